// SPDX-License-Identifier: BSD-3-Clause
// The part of the client that touches DDS, over the network path of one process.
#include "cleave/watch/watch_session.hpp"

#include <gtest/gtest.h>

#include "cleave/stream/find_sensor.hpp"
#include "cleave/stream/status_reader.hpp"
#include "fake_nodes.hpp"
#include "tests/unit/libcleave/test_stream.hpp"

namespace cleave::client {
namespace {

using test::eventually;

class WatchSessionTest : public testing::Test {
 protected:
  Shutdown shutdown_;
  Stream stream_{test::network_options()};
  std::string sensor_ = test::sensor_name();
  FakeNodes nodes_{stream_, sensor_};
  std::vector<std::string> lines_;

  WatchEnd run(WatchSession& session, std::optional<std::uint64_t> frames) {
    return session.run(shutdown_, frames,
                       [this](const std::string& line) { lines_.push_back(line); });
  }
};

TEST_F(WatchSessionTest, FollowsAStreamToItsEndAndAccountsForEveryFrame) {
  WatchSession session(stream_, sensor_, true);
  ASSERT_TRUE(eventually([&] { return nodes_.lists_are_read() && nodes_.clouds_are_read(); }));
  std::jthread publisher([this] {
    for (int i = 0; i < 10; ++i) nodes_.publish_frame();
    nodes_.publish_statuses(NodeState::ended);
  });
  EXPECT_EQ(run(session, std::nullopt), WatchEnd::source_ended);
  publisher.join();

  const WatchSummary summary = session.summary();
  EXPECT_EQ(summary.account.published, 10U);
  EXPECT_EQ(summary.account.segmented, 10U);
  EXPECT_EQ(summary.account.dropped, 0U);
  EXPECT_EQ(summary.segments.median, 1);
  EXPECT_GE(summary.latency_ms.median, 0);
  EXPECT_FALSE(summary.zero_copy) << "the network copies";
  EXPECT_EQ(lines_.size(), 10U);
  ASSERT_EQ(session.last_segments().segments.size(), 1U);
  EXPECT_EQ(session.last_segments().segments[0].point_count, 12U);
  const auto image = session.last_image();
  ASSERT_TRUE(image.has_value());
  EXPECT_EQ(image->width, 4U);
  EXPECT_EQ(image->label[11], 1);
}

TEST_F(WatchSessionTest, EndsAfterTheSegmentListsThatWereAskedFor) {
  WatchSession session(stream_, sensor_, false);
  ASSERT_TRUE(eventually([&] { return nodes_.lists_are_read(); }));
  std::jthread publisher([this](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      nodes_.publish_statuses(NodeState::running);
      nodes_.publish_frame();
    }
  });
  EXPECT_EQ(run(session, 3), WatchEnd::frames_reached);
  publisher.request_stop();
  publisher.join();
  const Account account = session.summary().account;
  EXPECT_GE(account.segmented, 3U);
  EXPECT_EQ(account.published, account.segmented);
  EXPECT_FALSE(session.last_image().has_value());
}

TEST_F(WatchSessionTest, EndsWhenItIsInterrupted) {
  WatchSession session(stream_, sensor_, false);
  shutdown_.request();
  EXPECT_EQ(run(session, std::nullopt), WatchEnd::interrupted);
  EXPECT_EQ(session.summary().account.published, 0U);
}

TEST_F(WatchSessionTest, FindsTheOnlySensorByItsNodes) {
  nodes_.publish_statuses(NodeState::running);
  EXPECT_EQ(find_sensor(stream_, shutdown_, "", std::chrono::seconds(10)), sensor_);
  EXPECT_EQ(find_sensor(stream_, shutdown_, "named", std::chrono::seconds(0)), "named");
}

TEST_F(WatchSessionTest, CollectsTheStatusesOfAllNodes) {
  nodes_.publish_statuses(NodeState::running);
  StatusReader statuses(stream_);
  const auto reports = statuses.collect(shutdown_, std::chrono::seconds(10));
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].node, "grabber/" + sensor_);
  EXPECT_EQ(reports[1].node, "segmenter/" + sensor_);
}

}  // namespace
}  // namespace cleave::client
