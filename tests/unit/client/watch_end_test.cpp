// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/watch/watch_end.hpp"

#include <gtest/gtest.h>

#include "cleave/stream/find_sensor.hpp"
#include "cleave/stream/node_table.hpp"
#include "cleave/watch/watch_report.hpp"
#include "reports.hpp"

namespace cleave::client {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

const SteadyTime watch_start{std::chrono::hours(1)};

TEST(EndCondition, ComesAfterTheSegmentListsThatWereAskedFor) {
  const FrameAccount account("camera");
  EndCondition condition(2, watch_start);
  condition.add_segment_list(watch_start);
  EXPECT_EQ(condition.check(account, watch_start), std::nullopt);
  condition.add_segment_list(watch_start);
  EXPECT_EQ(condition.check(account, watch_start), WatchEnd::frames_reached);
}

TEST(EndCondition, ComesWhenTheSourceHasEndedAndEveryFrameIsAccountedFor) {
  FrameAccount account("camera");
  const EndCondition condition(std::nullopt, watch_start);
  account.add_report(grabber(NodeState::ended, 3), watch_start);
  account.add_report(segmenter({.out = 2}), watch_start);
  EXPECT_EQ(condition.check(account, watch_start + 500ms), std::nullopt);
  account.add_report(segmenter({.out = 3}), watch_start + 500ms);
  EXPECT_EQ(condition.check(account, watch_start + 800ms), WatchEnd::source_ended);
}

TEST(EndCondition, ComesWhenNothingArrivesForHalfAMinute) {
  const FrameAccount account("camera");
  EndCondition condition(std::nullopt, watch_start);
  EXPECT_EQ(condition.check(account, watch_start + 29s), std::nullopt);
  condition.add_segment_list(watch_start + 29s);
  EXPECT_EQ(condition.check(account, watch_start + 31s), std::nullopt);
  EXPECT_EQ(condition.check(account, watch_start + 59s), WatchEnd::nothing_arrives);
}

TEST(WhyNothingArrives, NamesWhoIsMissing) {
  FrameAccount account("camera");
  EXPECT_NE(why_nothing_arrives(account, "camera", 7).find("on domain 7: neither a grabber nor"),
            std::string::npos);
  account.add_report(segmenter({}), watch_start);
  EXPECT_NE(why_nothing_arrives(account, "camera", 0).find("no grabber answers"),
            std::string::npos);
}

TEST(WhyNothingArrives, PassesOnWhatTheNodesSay) {
  FrameAccount account("camera");
  NodeReport report = grabber(NodeState::source_lost, 12);
  report.last_error = "unplugged";
  account.add_report(report, watch_start);
  const std::string why = why_nothing_arrives(account, "camera", 0);
  EXPECT_NE(why.find("grabber/camera says 'source lost'"), std::string::npos);
  EXPECT_NE(why.find("unplugged"), std::string::npos);
  EXPECT_NE(why.find("no segmenter answers"), std::string::npos);
}

TEST(OnlySensor, IsTheOneThereIsAndNoneOfSeveral) {
  EXPECT_EQ(only_sensor({"camera"}), "camera");
  EXPECT_THROW((void)only_sensor({"left", "right"}), std::runtime_error);
}

TEST(WatchReport, HasTheKeysThatScriptsReadInOneLine) {
  WatchSummary summary;
  summary.sensor = "camera";
  summary.account = {.published = 10, .segmented = 7, .dropped = 2, .rejected = 1};
  summary.account.dropped_by_cause = {{"queue", 2}};
  summary.latency_ms = {.median = 40.5, .p90 = 50, .p99 = 60};
  summary.segments.median = 14;
  const Json json = Json::parse(one_line(json_of(summary)));
  EXPECT_EQ(json["published"], 10);
  EXPECT_EQ(json["segmented"], 7);
  EXPECT_EQ(json["dropped"], 2);
  EXPECT_EQ(json["rejected"], 1);
  EXPECT_EQ(json["zero_copy"], false);
  EXPECT_EQ(json["latency_ms"]["median"], 40.5);
  EXPECT_EQ(json["latency_ms"]["p99"], 60);
  EXPECT_EQ(json["segments"]["median"], 14);
  EXPECT_EQ(json["dropped_by_cause"]["queue"], 2);
  EXPECT_EQ(json["rejected_by_cause"], Json::object());
  for (const char* key : {"fps", "transport", "transport_reason", "sensor"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

TEST(WatchReport, ShowsAFrameInALine) {
  const Account account{.published = 3, .segmented = 1, .dropped = 2, .rejected = 0};
  ListArrival arrival{};
  arrival.frame_id = 42;
  arrival.latency_ms = 12.34;
  arrival.segments = 9;
  EXPECT_EQ(
      frame_line(arrival, 29.97, true, account),
      "frame 42        9 segments   30.0 Hz    12.3 ms  zero copy yes  dropped 2  rejected 0");
  arrival.segments.reset();
  EXPECT_NE(frame_line(arrival, 0, false, account).find("rejected  "), std::string::npos);
}

TEST(NodeTable, ShowsCausesTransportAndErrorsBelowTheFigures) {
  NodeReport report = segmenter({.out = 5, .dropped = 2, .rejected = 1});
  report.transport_reason = "no RouDi answers at /tmp/roudi";
  report.last_error = "frame 3: bad size";
  const std::string text = node_table({report});
  for (const char* part : {"segmenter/camera  running  network", "dropped    2 queue",
                           "rejected   1 bad size", "no RouDi answers", "frame 3: bad size"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
}

}  // namespace
}  // namespace cleave::client
