// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/status.hpp"

#include <gtest/gtest.h>

#include "libcleave/reader.hpp"
#include "tests/unit/libcleave/test_stream.hpp"

namespace cleave {
namespace {

NodeReport full_report() {
  NodeReport report;
  report.node = "segmenter/" + test::sensor_name();
  report.version = "1.2.3";
  report.sensor = test::sensor_name();
  report.process_id = 42;
  report.state = NodeState::source_lost;
  report.transport_in_force = Transport::shared_memory;
  report.transport_reason = "RouDi answers";
  report.frames_in = 10;
  report.frames_out = 6;
  report.frames_dropped = 1;
  report.frames_rejected = 2;
  report.frames_in_flight = 1;
  report.frames_zero_copy = 9;
  report.interruptions = 3;
  report.dropped_by_cause = {{"queue", 1}};
  report.rejected_by_cause = {{"bad size", 1}, {"no finite point", 1}};
  report.rate_hz = 30;
  report.latency_p99_ms = 12.5F;
  report.last_error = "grabber gone";
  return report;
}

TEST(Status, ReachesALateJoinerAsItWasReported) {
  Stream stream(test::network_options());
  StatusPublisher publisher(stream);
  const NodeReport sent = full_report();
  publisher.publish(sent);

  Reader<NodeStatus> reader(stream, "");
  NodeReport received;
  ASSERT_TRUE(test::eventually([&] {
    while (auto sample = reader.take()) {
      if (report_of(**sample).node == sent.node) received = report_of(**sample);
    }
    return received.node == sent.node;
  }));
  EXPECT_EQ(received.state, NodeState::source_lost);
  EXPECT_EQ(received.transport_in_force, Transport::shared_memory);
  EXPECT_EQ(received.frames_in, 10U);
  EXPECT_EQ(received.interruptions, 3U);
  EXPECT_EQ(received.frames_zero_copy, 9U);
  EXPECT_EQ(received.rejected_by_cause, sent.rejected_by_cause);
  EXPECT_EQ(received.dropped_by_cause, sent.dropped_by_cause);
  EXPECT_EQ(received.latency_p99_ms, 12.5F);
  EXPECT_EQ(received.last_error, "grabber gone");
}

TEST(Status, NamesEveryState) {
  EXPECT_STREQ(to_string(NodeState::source_lost), "source lost");
  EXPECT_STREQ(to_string(static_cast<NodeState>(99)), "unknown");
}

}  // namespace
}  // namespace cleave
