// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/segment_list_buffer.hpp"

#include <gtest/gtest.h>

namespace cleave::service {
namespace {

segmentation::Segment example_segment() {
  segmentation::Segment segment;
  segment.label = 3;
  segment.point_count = 1234;
  segment.centroid = {1, 2, 3};
  segment.mean_normal = {0, 0, -1};
  segment.box.centre = {4, 5, 6};
  segment.box.orientation = Eigen::Quaternionf(0.1F, 0.2F, 0.3F, 0.4F);  // w, x, y, z
  segment.box.extent = {0.3F, 0.2F, 0.1F};
  segment.rectangle = {10, 20, 30, 40};
  segment.planarity = 0.75F;
  return segment;
}

TEST(SegmentListBuffer, CarriesEveryFieldOfASegment) {
  SegmentListBuffer buffer;
  buffer.fill({{example_segment()}, {}});

  ASSERT_EQ(buffer.list().segments._length, 1U);
  const SegmentMessage& message = buffer.list().segments._buffer[0];
  EXPECT_EQ(message.label, 3);
  EXPECT_EQ(message.point_count, 1234U);
  EXPECT_EQ(message.centroid.x, 1);
  EXPECT_EQ(message.centroid.y, 2);
  EXPECT_EQ(message.centroid.z, 3);
  EXPECT_EQ(message.mean_normal.z, -1);
  EXPECT_EQ(message.box.centre.y, 5);
  EXPECT_EQ(message.box.orientation.w, 0.1F);
  EXPECT_EQ(message.box.orientation.x, 0.2F);
  EXPECT_EQ(message.box.orientation.y, 0.3F);
  EXPECT_EQ(message.box.orientation.z, 0.4F);
  EXPECT_EQ(message.box.extent.x, 0.3F);
  EXPECT_EQ(message.box.extent.z, 0.1F);
  EXPECT_EQ(message.rectangle.left, 10U);
  EXPECT_EQ(message.rectangle.top, 20U);
  EXPECT_EQ(message.rectangle.right, 30U);
  EXPECT_EQ(message.rectangle.bottom, 40U);
  EXPECT_EQ(message.planarity, 0.75F);
}

TEST(SegmentListBuffer, CarriesBordersWithTheirKind) {
  SegmentListBuffer buffer;
  buffer.fill(
      {{}, {{1, 2, segmentation::BorderKind::concave}, {1, 3, segmentation::BorderKind::convex}}});

  ASSERT_EQ(buffer.list().borders._length, 2U);
  EXPECT_EQ(buffer.list().borders._buffer[0].second, 2);
  EXPECT_EQ(buffer.list().borders._buffer[0].kind, cleave_v1_BORDER_CONCAVE);
  EXPECT_EQ(buffer.list().borders._buffer[1].first, 1);
  EXPECT_EQ(buffer.list().borders._buffer[1].kind, cleave_v1_BORDER_CONVEX);
}

TEST(SegmentListBuffer, IsEmptyForAnEmptySegmentationAfterAFullOne) {
  SegmentListBuffer buffer;
  buffer.fill({{example_segment()}, {{1, 2, segmentation::BorderKind::convex}}});
  buffer.fill({});

  EXPECT_EQ(buffer.list().segments._length, 0U);
  EXPECT_EQ(buffer.list().borders._length, 0U);
}

TEST(SegmentListBuffer, KeepsItsMemoryAndNeverHandsItOver) {
  SegmentListBuffer buffer;
  buffer.fill({{example_segment(), example_segment()}, {}});
  const SegmentMessage* const memory = buffer.list().segments._buffer;
  buffer.fill({{example_segment()}, {}});

  EXPECT_EQ(buffer.list().segments._buffer, memory);
  EXPECT_FALSE(buffer.list().segments._release);
  EXPECT_FALSE(buffer.list().borders._release);
}

}  // namespace
}  // namespace cleave::service
