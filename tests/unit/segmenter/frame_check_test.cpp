// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/frame_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>

namespace cleave::service {
namespace {

constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();

FrameHeader good_header() {
  FrameHeader header{};
  header.width = 640;
  header.height = 480;
  EXPECT_TRUE(set_name(header.sensor, "camera"));
  EXPECT_TRUE(set_name(header.coordinate_frame, "camera_depth_optical_frame"));
  return header;
}

std::optional<RejectCause> check_size(std::uint32_t width, std::uint32_t height) {
  FrameHeader header = good_header();
  header.width = width;
  header.height = height;
  return check_header(header, "camera", small_capacity_points);
}

TEST(FrameCheck, AcceptsAFullFrame) {
  EXPECT_EQ(check_header(good_header(), "camera", small_capacity_points), std::nullopt);
}

TEST(FrameCheck, AcceptsASinglePoint) {
  EXPECT_EQ(check_size(1, 1), std::nullopt);
}

TEST(FrameCheck, AcceptsAnUnorganisedCloudOfFullCapacity) {
  EXPECT_EQ(check_size(307200, 1), std::nullopt);
}

TEST(FrameCheck, RejectsACloudWithoutColumns) {
  EXPECT_EQ(check_size(0, 480), RejectCause::bad_size);
}

TEST(FrameCheck, RejectsACloudWithoutRows) {
  EXPECT_EQ(check_size(640, 0), RejectCause::bad_size);
}

TEST(FrameCheck, RejectsOnePointMoreThanTheCapacity) {
  EXPECT_EQ(check_size(307201, 1), RejectCause::bad_size);
}

TEST(FrameCheck, RejectsOneRowMoreThanTheCapacity) {
  EXPECT_EQ(check_size(640, 481), RejectCause::bad_size);
}

TEST(FrameCheck, RejectsSizesWhoseProductOverflows) {
  EXPECT_EQ(check_size(65536, 65536), RejectCause::bad_size);
  EXPECT_EQ(check_size(largest, largest), RejectCause::bad_size);
}

TEST(FrameCheck, RejectsASensorNameThatDoesNotEnd) {
  FrameHeader header = good_header();
  std::fill(std::begin(header.sensor), std::end(header.sensor), 'x');

  EXPECT_EQ(check_header(header, "camera", small_capacity_points), RejectCause::bad_header);
}

TEST(FrameCheck, RejectsAnEmptySensorName) {
  FrameHeader header = good_header();
  header.sensor[0] = '\0';

  EXPECT_EQ(check_header(header, "camera", small_capacity_points), RejectCause::bad_header);
}

TEST(FrameCheck, RejectsAnotherSensorsFrame) {
  EXPECT_EQ(check_header(good_header(), "camera2", small_capacity_points), RejectCause::bad_header);
  EXPECT_EQ(check_header(good_header(), "cam", small_capacity_points), RejectCause::bad_header);
}

TEST(FrameCheck, RejectsAParentFrameThatDoesNotEndAndAnswersWithoutIt) {
  FrameHeader header = good_header();
  std::fill(std::begin(header.parent_frame), std::end(header.parent_frame), 'x');

  EXPECT_EQ(check_header(header, "camera", small_capacity_points), RejectCause::bad_header);
  EXPECT_EQ(name_of(answerable(header, "camera").parent_frame), "");
}

TEST(FrameCheck, TakesALargeCloudOfTheLargeTypeAlone) {
  FrameHeader header = good_header();
  header.width = 848;

  EXPECT_EQ(check_header(header, "camera", capacity_points), std::nullopt);
  EXPECT_EQ(check_header(header, "camera", small_capacity_points), RejectCause::bad_size);
}

TEST(FrameCheck, RejectsACoordinateFrameThatDoesNotEnd) {
  FrameHeader header = good_header();
  std::fill(std::begin(header.coordinate_frame), std::end(header.coordinate_frame), 'x');

  EXPECT_EQ(check_header(header, "camera", small_capacity_points), RejectCause::bad_header);
}

TEST(FrameCheck, AnswersABadHeaderUnderTheSensorsNameWithNamesThatEnd) {
  FrameHeader header = good_header();
  header.frame_id = 9;
  std::fill(std::begin(header.sensor), std::end(header.sensor), 'x');
  std::fill(std::begin(header.coordinate_frame), std::end(header.coordinate_frame), 'x');

  const FrameHeader answer = answerable(header, "camera");

  EXPECT_EQ(name_of(answer.sensor), "camera");
  EXPECT_EQ(name_of(answer.coordinate_frame), "");
  EXPECT_EQ(answer.frame_id, 9U);
}

TEST(FrameCheck, TellsEveryOutcomeApartOnTheWire) {
  EXPECT_EQ(wire_outcome(reject_cause(segmentation::Outcome::segmented)),
            cleave_v1_OUTCOME_SEGMENTED);
  EXPECT_EQ(wire_outcome(reject_cause(segmentation::Outcome::bad_size)),
            cleave_v1_OUTCOME_REJECTED_BAD_SIZE);
  EXPECT_EQ(wire_outcome(reject_cause(segmentation::Outcome::no_finite_point)),
            cleave_v1_OUTCOME_REJECTED_NO_FINITE_POINT);
  EXPECT_EQ(wire_outcome(reject_cause(segmentation::Outcome::too_many_segments)),
            cleave_v1_OUTCOME_REJECTED_TOO_MANY_SEGMENTS);
  EXPECT_EQ(wire_outcome(RejectCause::bad_header), cleave_v1_OUTCOME_REJECTED_BAD_HEADER);
  EXPECT_EQ(wire_outcome(RejectCause::wrong_unit), cleave_v1_OUTCOME_REJECTED_WRONG_UNIT);
}

}  // namespace
}  // namespace cleave::service
