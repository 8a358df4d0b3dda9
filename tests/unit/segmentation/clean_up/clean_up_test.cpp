// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/clean_up.hpp"

#include <gtest/gtest.h>

namespace cleave::segmentation {
namespace {

SupervoxelEdge edge(std::uint32_t first, std::uint32_t second, float weight, bool valid = true,
                    std::uint32_t touching_voxels = 1) {
  return {.first = first,
          .second = second,
          .touching_voxels = touching_voxels,
          .weight = weight,
          .valid = valid};
}

std::vector<std::uint32_t> merge(const std::vector<SupervoxelEdge>& edges,
                                 const std::vector<std::uint32_t>& points, std::uint32_t min_points,
                                 std::vector<std::uint32_t> segment) {
  const auto segments = static_cast<std::uint32_t>(segment.size());
  const CleanUpOptions options{.min_segment_points = min_points, .weak_border_points = 0};
  SmallSegmentMerger().merge(edges, points, segments, options, segment);
  return segment;
}

using Segments = std::vector<std::uint32_t>;

TEST(SmallSegmentMerger, JoinsTheNeighbourWithTheLargestSummedWeight) {
  // Two edges of 0.4 to segment 0 outweigh one of 0.6 to segment 2.
  const std::vector<SupervoxelEdge> edges = {edge(0, 1, 0.4F), edge(1, 3, 0.4F), edge(1, 2, 0.6F)};

  EXPECT_EQ(merge(edges, {500, 50, 500, 500}, 200, {0, 1, 2, 0}), (Segments{0, 0, 2, 0}));
}

TEST(SmallSegmentMerger, FallsBackOnTheLongestBorderWithoutAValidEdge) {
  const std::vector<SupervoxelEdge> edges = {edge(0, 1, 1, false, 3), edge(1, 2, 0.1F, false, 8)};

  EXPECT_EQ(merge(edges, {500, 50, 500}, 200, {0, 1, 2}), (Segments{0, 2, 2}));
}

TEST(SmallSegmentMerger, LetsTheSmallestGoFirstSoThatSliversCanGrowTogether) {
  const std::vector<SupervoxelEdge> edges = {edge(0, 1, 0.9F), edge(1, 2, 0.5F)};

  // 1 joins 0 and makes it large enough: 0 does not go on to join 2.
  EXPECT_EQ(merge(edges, {150, 60, 500}, 200, {0, 1, 2}), (Segments{0, 0, 2}));
}

TEST(SmallSegmentMerger, LeavesAnIslandAndWhatIsLargeEnoughAlone) {
  EXPECT_EQ(merge({edge(1, 2, 1)}, {5, 200, 200}, 200, {0, 1, 2}), (Segments{0, 1, 2}));
}

TEST(SmallSegmentMerger, IsSwitchedOffByZero) {
  EXPECT_EQ(merge({edge(0, 1, 1)}, {1, 1}, 0, {0, 1}), (Segments{0, 1}));
}

TEST(SmallSegmentMerger, JoinsSegmentsOfSomeSizeAcrossWeakBordersOnly) {
  const CleanUpOptions options{.min_segment_points = 200, .weak_border_points = 500};
  const auto merged = [&options](float share, std::uint32_t small, std::uint32_t large) {
    SupervoxelEdge border = edge(0, 1, 0.1F);
    border.cannot_link_share = share;
    Segments segment = {0, 1};
    SmallSegmentMerger().merge({border}, {small, large}, 2, options, segment);
    return segment[0] == segment[1];
  };

  EXPECT_TRUE(merged(0.9F, 400, 100000)) << "a part of a cannot-link edge is weak";
  EXPECT_FALSE(merged(1, 400, 100000));
  EXPECT_FALSE(merged(0.9F, 600, 100000)) << "a body of its own";
  EXPECT_TRUE(merged(0.9F, 600, 1400)) << "two small neighbours";
  EXPECT_TRUE(merged(1, 100, 100000)) << "a sliver";
}

TEST(SmallSegmentMerger, CallsABorderWeakByItsLength) {
  const CleanUpOptions options{.min_segment_points = 0, .weak_border_points = 500};
  SupervoxelEdge strong = edge(0, 2, 0.1F, true, 6);
  strong.cannot_link_share = 1;
  const SupervoxelEdge weak = edge(1, 2, 0.1F, true, 5);
  Segments segment = {0, 0, 1};

  SmallSegmentMerger().merge({strong, weak}, {50000, 50000, 300}, 2, options, segment);

  EXPECT_EQ(segment, (Segments{0, 0, 1})) << "5 of 11 links are not half";
}

}  // namespace
}  // namespace cleave::segmentation
