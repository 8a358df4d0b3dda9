// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/stream_summary.hpp"

#include <gtest/gtest.h>

#include "cleave/stream/contract_frames.hpp"
#include "cleave/stream/list_arrival.hpp"
#include "cleave/stream/segment_message.hpp"
#include "cleave/watch/cpu_share.hpp"
#include "console/contract_json.hpp"

namespace cleave::client {
namespace {

using std::chrono_literals::operator""ms;
using Time = std::chrono::steady_clock::time_point;

const Time summary_start{std::chrono::hours(1)};

ListArrival arrival(std::uint64_t frame_id, std::uint32_t epoch, Time time) {
  return {.frame_id = frame_id,
          .epoch = epoch,
          .latency_ms = 10,
          .stage_ms = {1, 2, 3, 4, 0.5, 0.5},
          .segments = 4,
          .time = time};
}

TEST(StreamSummary, MeasuresTheRateBetweenTheFirstAndTheLastList) {
  StreamSummary summary;
  EXPECT_EQ(summary.mean_rate_hz(), 0);
  for (int i = 0; i < 101; ++i) {
    summary.add(arrival(static_cast<std::uint64_t>(i), 0, summary_start + i * 20ms));
  }
  EXPECT_DOUBLE_EQ(summary.mean_rate_hz(), 50);
  EXPECT_DOUBLE_EQ(summary.recent_rate_hz(), 50);
  EXPECT_EQ(summary.lists(), 101U);
}

TEST(StreamSummary, FollowsAChangeOfRate) {
  StreamSummary summary;
  for (int i = 0; i < 60; ++i) summary.add(arrival(0, 0, summary_start + i * 100ms));
  for (int i = 0; i < 30; ++i) summary.add(arrival(0, 0, summary_start + 6000ms + i * 10ms));
  EXPECT_DOUBLE_EQ(summary.recent_rate_hz(), 100);
}

TEST(StreamSummary, CountsFrameIdsThatWereLeftOutWithinAnEpoch) {
  StreamSummary summary;
  summary.add(arrival(10, 0, summary_start));
  summary.add(arrival(11, 0, summary_start));
  summary.add(arrival(15, 0, summary_start));
  EXPECT_EQ(summary.gaps(), 3U);
  summary.add(arrival(100, 1, summary_start));
  summary.add(arrival(3, 1, summary_start));
  EXPECT_EQ(summary.gaps(), 3U) << "neither a new epoch nor a restart is a gap";
}

TEST(StreamSummary, LeavesRejectedFramesOutOfLatencyAndSegments) {
  StreamSummary summary;
  summary.add(arrival(1, 0, summary_start));
  ListArrival rejected = arrival(2, 0, summary_start);
  rejected.latency_ms = 0.1;
  rejected.segments.reset();
  summary.add(rejected);
  summary.add(rejected);
  EXPECT_EQ(summary.lists(), 3U);
  EXPECT_EQ(summary.segments().median, 4);
  EXPECT_EQ(summary.latency_ms().median, 10);
}

// A segment list as DDS would hand it out.
struct Message {
  SegmentMessage segment{};
  BorderMessage border{};
  SegmentList list{};
  Message() {
    (void)set_name(list.header.sensor, "camera");
    list.header.frame_id = 7;
    list.header.width = 640;
    list.header.height = 480;
    list.cloud_publication_time_ns = 3'600'000'000'000 - 25'000'000;
    segment.label = 1;
    segment.point_count = 1234;
    segment.centroid = {0.1F, 0.2F, 0.9F};
    segment.planarity = 0.75F;
    border = {1, 2, cleave_v1_BORDER_CONVEX};
    list.segments = {1, 1, &segment, false};
    list.borders = {1, 1, &border, false};
  }
};

TEST(ListArrival, MeasuresFromThePublicationOfTheCloud) {
  const Message message;
  const ListArrival arrival = arrival_of(message.list, summary_start);
  EXPECT_DOUBLE_EQ(arrival.latency_ms, 25);
  EXPECT_EQ(arrival.segments, 1U);
}

TEST(ListArrival, TellsEachStageFromTheOthers) {
  Message message;
  const auto before_ns = [](std::int64_t ms) { return (3'600'000 - ms) * 1'000'000; };
  SegmentList& list = message.list;
  list.header.arrival_time_ns = before_ns(31);
  list.cloud_publication_time_ns = before_ns(25);
  list.cloud_reception_time_ns = before_ns(24);
  list.queue_ms = 5;
  list.segmentation_ms = 12;
  list.header.publication_time_ns = before_ns(4);

  const StageTimes stage_ms = arrival_of(list, summary_start).stage_ms;

  EXPECT_EQ(stage_ms, (StageTimes{6, 1, 5, 12, 3, 4}));
}

TEST(StreamSummary, AddsUpTheStagesOfEveryFrame) {
  StreamSummary summary;
  for (int i = 0; i < 10; ++i) summary.add(arrival(1, 0, summary_start));

  EXPECT_EQ(summary.stage_ms(1).median, 2);
  EXPECT_EQ(summary.total_ms().p99, 11);
}

TEST(CpuShare, CountsFromTheFirstFrameToTheLast) {
  CpuShare cpu;
  EXPECT_EQ(cpu.share(), 0);
  const auto report = [](std::uint64_t frames, double cpu_time_s) {
    NodeReport r;
    r.frames_in = frames;
    r.cpu_time_s = cpu_time_s;
    return r;
  };
  cpu.add(report(0, 5), summary_start);
  cpu.add(report(0, 6), summary_start + 1000ms);
  cpu.add(report(30, 6.3), summary_start + 2000ms);
  cpu.add(report(60, 6.5), summary_start + 3000ms);
  cpu.add(report(60, 6.9), summary_start + 9000ms);

  EXPECT_DOUBLE_EQ(cpu.share(), 0.25);
}

TEST(CpuShare, StartsAnewWithANewProcess) {
  CpuShare cpu;
  NodeReport r;
  r.frames_in = 10;
  r.cpu_time_s = 100;
  cpu.add(r, summary_start);
  r.process_id = 2;
  r.cpu_time_s = 1;
  cpu.add(r, summary_start + 1000ms);
  r.frames_in = 20;
  r.cpu_time_s = 1.5;
  cpu.add(r, summary_start + 2000ms);

  EXPECT_DOUBLE_EQ(cpu.share(), 0.5);
}

TEST(SegmentMessage, IsTextForPeople) {
  const Message message;
  const std::string text = text_of(frame_of(message.list));
  for (const char* part : {"frame 7", "sensor camera", "640 x 480", "1 segments, 1 borders", "1234",
                           "0.100 0.200 0.900", "0.75", "2+"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
}

TEST(SegmentMessage, IsJsonWithTheContractsKeys) {
  const Message message;
  const Json json = Json::parse(one_line(contract_json(frame_of(message.list))));
  EXPECT_EQ(json["header"]["frame_id"], 7);
  EXPECT_EQ(json["outcome"], "segmented");
  EXPECT_EQ(json["segments"][0]["point_count"], 1234);
  EXPECT_EQ(json["segments"][0]["centroid"], Json::parse("[0.1, 0.2, 0.9]"));
  EXPECT_EQ(json["borders"][0]["kind"], "convex");
}

TEST(SegmentMessage, OfARejectedFrameSaysWhy) {
  Message message;
  message.list.outcome = cleave_v1_OUTCOME_REJECTED_BAD_SIZE;
  message.list.segments._length = 0;
  EXPECT_NE(text_of(frame_of(message.list)).find("rejected: bad size"), std::string::npos);
  EXPECT_EQ(arrival_of(message.list, summary_start).segments, std::nullopt);
}

}  // namespace
}  // namespace cleave::client
