// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/partition.hpp"

#include <gtest/gtest.h>

namespace cleave::segmentation {
namespace {

// Square sheets of side x side supervoxels, side by side; neighbouring sheets meet in a crease.
std::vector<SupervoxelEdge> sheets(std::uint32_t count, std::uint32_t side) {
  std::vector<SupervoxelEdge> edges;
  const std::uint32_t width = count * side;
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const std::uint32_t v = row * width + column;
      const bool crease = (column + 1) % side == 0;
      if (column + 1 < width) {
        edges.push_back({.first = v,
                         .second = v + 1,
                         .touching_voxels = 1,
                         .weight = crease ? 0.05F : 1,
                         .valid = true,
                         .cannot_link_share = crease ? 1.0F : 0.0F});
      }
      if (row + 1 < side) {
        edges.push_back(
            {.first = v, .second = v + width, .touching_voxels = 1, .weight = 1, .valid = true});
      }
    }
  }
  return edges;
}

TEST(Partitioner, CutsSheetsApartAtTheirCreases) {
  for (const std::uint32_t side : {3U, 8U, 15U}) {
    const auto edges = sheets(5, side);
    std::vector<std::uint32_t> segment;

    const std::uint32_t segments = Partitioner().partition(5 * side * side, edges, {}, segment);

    EXPECT_EQ(segments, 5U);
    for (std::uint32_t v = 0; v < segment.size(); ++v) {
      EXPECT_EQ(segment[v], segment[v % (5 * side) / side * side]) << v;
    }
  }
}

TEST(Partitioner, LeavesAGraphWithoutCannotLinkEdgesWhole) {
  auto edges = sheets(3, 4);
  for (auto& edge : edges) edge.cannot_link_share = 0;
  std::vector<std::uint32_t> segment;

  EXPECT_EQ(Partitioner().partition(48, edges, {}, segment), 1U);
}

TEST(Partitioner, DoesNotConnectThroughInvalidEdges) {
  auto edges = sheets(3, 4);
  for (auto& edge : edges) edge.valid = !edge.is_cannot_link();
  std::vector<std::uint32_t> segment;

  EXPECT_EQ(Partitioner().partition(48, edges, {}, segment), 3U);
}

TEST(Partitioner, MakesALoneSupervoxelASegment) {
  std::vector<std::uint32_t> segment;

  EXPECT_EQ(Partitioner().partition(1, {}, {}, segment), 1U);
  EXPECT_EQ(segment, std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace cleave::segmentation
