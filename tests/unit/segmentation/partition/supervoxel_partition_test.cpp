// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/supervoxel_partition.hpp"

#include <gtest/gtest.h>

namespace cleave::segmentation {
namespace {

// A floor and a wall that meet in a concave crease, `side` x `side` supervoxels of 3 cm each.
ForeignSupervoxels floor_and_wall(std::uint32_t side) {
  ForeignSupervoxels s;
  const auto at = [side](std::uint32_t row, std::uint32_t column) { return row * side + column; };
  for (std::uint32_t row = 0; row < 2 * side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      const float x_m = 0.03F * static_cast<float>(column);
      const float along_m = 0.03F * (static_cast<float>(row % side) + 0.5F);
      const float back_m = 0.03F * static_cast<float>(side);
      const bool floor = row < side;
      s.surfel.push_back({.position = floor ? Eigen::Vector3f(x_m, 0.5F, 1 + along_m)
                                            : Eigen::Vector3f(x_m, 0.5F - along_m, 1 + back_m),
                          .normal = floor ? Eigen::Vector3f(0, -1, 0) : Eigen::Vector3f(0, 0, -1)});
      s.point_count.push_back(100);
      if (column + 1 < side) s.adjacent_pairs.push_back({at(row, column), at(row, column + 1), 5});
      if (row + 1 < 2 * side) s.adjacent_pairs.push_back({at(row, column), at(row + 1, column), 5});
    }
  }
  return s;
}

TEST(SupervoxelPartitioner, CutsAlongTheCreaseOfOthersSupervoxels) {
  const std::uint32_t side = 6;
  std::vector<std::uint32_t> segment;

  const std::uint32_t segments =
      SupervoxelPartitioner().partition(floor_and_wall(side), {}, segment);

  ASSERT_EQ(segments, 2U);
  for (std::size_t i = 0; i < segment.size(); ++i) {
    EXPECT_EQ(segment[i] == segment[0], i < std::size_t{side} * side) << i;
  }
}

TEST(SupervoxelPartitioner, JoinsSliversToTheirNeighbours) {
  ForeignSupervoxels s = floor_and_wall(6);
  s.point_count.assign(s.point_count.size(), 5);  // the wall: 180 points
  std::vector<std::uint32_t> segment;

  Options options;
  options.clean_up.min_segment_points = 200;
  (void)SupervoxelPartitioner().partition(s, options, segment);

  EXPECT_EQ(segment, std::vector<std::uint32_t>(segment.size(), segment[0]));
}

TEST(SupervoxelPartitioner, TakesNoSupervoxelsAtAll) {
  std::vector<std::uint32_t> segment;

  EXPECT_EQ(SupervoxelPartitioner().partition({}, {}, segment), 0U);
  EXPECT_TRUE(segment.empty());
}

}  // namespace
}  // namespace cleave::segmentation
