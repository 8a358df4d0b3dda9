// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline with segmenters of random duration: what the daemon does but for DDS.
#include "segmenter/pipeline/frame_pipeline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/unit/segmenter/pipeline_fixture.hpp"

namespace cleave::service {
namespace {

using namespace test;

class FramePipelineWorkers : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Counts, FramePipelineWorkers, testing::Values(1, 2, 4, 6));

TEST_P(FramePipelineWorkers, PublishEveryFrameOf200InOrderInLosslessMode) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, random_workers(GetParam()));

  std::vector<std::uint64_t> sent;
  for (std::uint64_t id = 1; id <= 200; ++id) {
    pipeline.accept(received(cloud(id), true));
    sent.push_back(id);
    expect_balanced(pipeline.counts());
  }
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), sent);
  EXPECT_EQ(sink.label_ids, sent);
  EXPECT_TRUE(std::equal(sent.begin(), sent.end(), sink.first_labels.begin()));
  EXPECT_EQ(pipeline.counts().published, 200U);
  EXPECT_EQ(pipeline.counts().zero_copy, 200U);
  EXPECT_EQ(pipeline.counts().in_flight, 0U);
  EXPECT_LE(sink.most_loans, static_cast<int>(ResultSink::max_loans));
}

TEST_P(FramePipelineWorkers, KeepOrderAndBooksInLiveModeWhenOverrun) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, random_workers(GetParam()));

  for (std::uint64_t id = 1; id <= 200; ++id) {
    pipeline.accept(received(cloud(id), true));
    if (id % 4 == 0) std::this_thread::sleep_for(std::chrono::microseconds(500));
    expect_balanced(pipeline.counts());
  }
  pipeline.drain();

  const std::vector<std::uint64_t> ids = sink.list_ids();
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(ids.back(), 200U);
  const FrameCounts counts = pipeline.counts();
  EXPECT_EQ(counts.published, ids.size());
  EXPECT_EQ(counts.received, 200U);
  EXPECT_EQ(counts.published + counts.dropped_total(), 200U);
  EXPECT_EQ(counts.dropped_total(), counts.dropped.at(static_cast<std::size_t>(DropCause::queue)));
  EXPECT_LE(sink.most_loans, static_cast<int>(ResultSink::max_loans));
}

TEST(FramePipeline, AnswersABadSizeInItsPlaceInTheOrder) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, random_workers(2));
  const auto bad = cloud(2);
  bad->header.width = 641;
  bad->header.height = 480;

  pipeline.accept(received(cloud(1), false));
  pipeline.accept(received(bad, false));
  pipeline.accept(received(cloud(3), false));
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(sink.lists[1].outcome, cleave_v1_OUTCOME_REJECTED_BAD_SIZE);
  EXPECT_EQ(sink.lists[1].segments, 0U);
  EXPECT_EQ(sink.label_ids, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(pipeline.counts().rejected_total(), 1U);
  EXPECT_NE(pipeline.last_problem().find("bad size"), std::string::npos);
  expect_balanced(pipeline.counts());
}

TEST(FramePipeline, AnswersABadHeaderUnderTheSensorsName) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, random_workers(1));
  const auto foreign = cloud(2);
  ASSERT_TRUE(set_name(foreign->header.sensor, "other"));

  for (const auto& frame : {cloud(1), foreign, cloud(3)}) pipeline.accept(received(frame, false));
  pipeline.drain();

  EXPECT_EQ(sink.lists.at(1).outcome, cleave_v1_OUTCOME_REJECTED_BAD_HEADER);
  EXPECT_EQ(sink.lists.at(1).sensor, "camera");
  EXPECT_EQ(pipeline.counts().received, 3U);
  EXPECT_EQ(pipeline.counts().published, 2U);
  EXPECT_EQ(pipeline.counts().dropped_total(), 0U);
}

TEST(FramePipeline, RejectsACloudWithoutAFinitePointAndPublishesNoLabelsForIt) {
  FakeSink sink;
  const SegmentFunction nothing_there = [](const CloudView&, std::span<std::uint16_t>,
                                           Segmentation&) { return Outcome::no_finite_point; };
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, {nothing_there});

  pipeline.accept(received(cloud(1), false));
  pipeline.drain();

  ASSERT_EQ(sink.lists.size(), 1U);
  EXPECT_EQ(sink.lists[0].outcome, cleave_v1_OUTCOME_REJECTED_NO_FINITE_POINT);
  EXPECT_TRUE(sink.label_ids.empty());
  EXPECT_EQ(pipeline.counts().rejected_total(), 1U);
}

// As a camera that measures millimetres sees a slope.
std::shared_ptr<DepthCloud> slope_in_millimetres(std::uint64_t id) {
  auto slope = cloud(id);
  slope->header.width = 40;
  slope->header.height = 30;
  for (std::size_t i = 0; i < 40 * 30; ++i) {
    const auto u = static_cast<float>(i % 40), v = static_cast<float>(i / 40);
    const float z = 700 + 10 * v;
    const float point[] = {z * (u - 20) / 60, z * (v - 15) / 60, z};
    std::copy_n(point, 3, slope->xyz + 3 * i);
  }
  return slope;
}

TEST(FramePipeline, SegmentsWhatLooksLikeMillimetresIfItIsToldNotToCheck) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8, false}, sink, random_workers(1));
  pipeline.accept(received(slope_in_millimetres(1), false));
  pipeline.drain();

  ASSERT_EQ(sink.lists.size(), 1U);
  EXPECT_EQ(sink.lists[0].outcome, cleave_v1_OUTCOME_SEGMENTED);
}

TEST(FramePipeline, RejectsAFrameInMillimetresAndSaysWhatItSaw) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, random_workers(1));

  for (const auto& frame : {cloud(1), slope_in_millimetres(2)})
    pipeline.accept(received(frame, false));
  pipeline.drain();

  ASSERT_EQ(sink.lists.size(), 2U);
  EXPECT_EQ(sink.lists[0].outcome, cleave_v1_OUTCOME_SEGMENTED);
  EXPECT_EQ(sink.lists[1].outcome, cleave_v1_OUTCOME_REJECTED_WRONG_UNIT);
  EXPECT_NE(pipeline.last_problem().find("millimetres"), std::string::npos);
  EXPECT_EQ(sink.label_ids, (std::vector<std::uint64_t>{1}));
}

// As the first points of the frames say: no segment at all, no finite point, single points.
enum Find : std::uint64_t { nothing = 1, no_point = 2, single_points = 3 };

Outcome find_as_told(const CloudView& view, std::span<std::uint16_t> labels, Segmentation& result) {
  const auto find = static_cast<Find>(view.point(0)[0]);
  if (find == no_point) return Outcome::no_finite_point;
  std::fill(labels.begin(), labels.end(), std::uint16_t{0});
  result.measured_points = static_cast<std::uint32_t>(labels.size());
  if (find == single_points) result.segments.resize(labels.size());
  for (segmentation::Segment& segment : result.segments) segment.point_count = 1;
  return Outcome::segmented;
}

std::string last_problem_after(const std::vector<Find>& finds) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, {find_as_told});
  for (std::uint64_t id = 1; id <= finds.size(); ++id) {
    const auto frame = cloud(id);
    frame->xyz[0] = static_cast<float>(finds[id - 1]);
    pipeline.accept(received(frame, false));
  }
  pipeline.drain();
  return pipeline.last_problem();
}

TEST(FramePipeline, SaysOnceThatMostPointsHaveNoSegment) {
  EXPECT_NE(last_problem_after({nothing}).find("most points have no segment"), std::string::npos);
  EXPECT_NE(last_problem_after({nothing, no_point, nothing}).find("no finite point"),
            std::string::npos);
}

TEST(FramePipeline, SaysOnceThatMostSegmentsAreSinglePointsWhateverElseItSaid) {
  EXPECT_NE(last_problem_after({nothing, single_points}).find("single points"), std::string::npos);
  EXPECT_NE(last_problem_after({single_points, nothing}).find("no segment"), std::string::npos);
  EXPECT_NE(last_problem_after({single_points, no_point, single_points}).find("no finite point"),
            std::string::npos);
}

TEST(FramePipeline, AnswersAFrameOnWhichTheSegmenterThrows) {
  FakeSink sink;
  const SegmentFunction throws_on_two = [](const CloudView& view, std::span<std::uint16_t> labels,
                                           Segmentation& result) {
    if (view.point(0)[0] == 2) throw std::runtime_error("out of luck");
    return echo(view, labels, result);
  };
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, {throws_on_two});

  for (std::uint64_t id = 1; id <= 3; ++id) pipeline.accept(received(cloud(id), false));
  pipeline.drain();

  ASSERT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(sink.lists[1].outcome, cleave_v1_OUTCOME_REJECTED_SEGMENTATION_FAILED);
  EXPECT_EQ(sink.lists[1].segments, 0U);
  EXPECT_EQ(sink.label_ids, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(pipeline.counts().rejected_total(), 1U);
  EXPECT_NE(pipeline.last_problem().find("out of luck"), std::string::npos);
}

TEST(FramePipeline, DropsAndCountsAFrameWhenNoChunkIsFree) {
  FakeSink sink;
  sink.exhausted = true;
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, random_workers(1));

  pipeline.accept(received(cloud(1), false));
  pipeline.drain();

  EXPECT_TRUE(sink.lists.empty());
  EXPECT_EQ(pipeline.counts().dropped.at(static_cast<std::size_t>(DropCause::no_free_chunk)), 1U);
  expect_balanced(pipeline.counts());
}

TEST(FramePipeline, CountsAFrameAsDroppedWhenItsResultsAreRefused) {
  FakeSink sink;
  sink.refuses = true;
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, random_workers(1));

  pipeline.accept(received(cloud(1), false));
  pipeline.drain();

  EXPECT_EQ(pipeline.counts().published, 0U);
  EXPECT_EQ(pipeline.counts().dropped.at(static_cast<std::size_t>(DropCause::refused_by_dds)), 1U);
}

}  // namespace
}  // namespace cleave::service
