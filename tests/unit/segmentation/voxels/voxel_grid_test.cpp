// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/voxel_grid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/voxels/voxel_neighbours.hpp"
#include "tests/unit/segmentation/support/random_points.hpp"

namespace cleave::segmentation {
namespace {

using Cell = std::array<int, 3>;

Cell metric_cell(const PointSet& points, std::size_t i, float size_m) {
  const float per_m = 1 / size_m;
  return {static_cast<int>(std::floor(points.x[i] * per_m)),
          static_cast<int>(std::floor(points.y[i] * per_m)),
          static_cast<int>(std::floor(points.z[i] * per_m))};
}

std::vector<std::uint32_t> voxel_of_point(const VoxelGrid& grid) {
  std::vector<std::uint32_t> voxel;
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    voxel.resize(grid.run_begin[run + 1], grid.run_voxel[run]);
  }
  return voxel;
}

TEST(CellRanking, RanksKeysAsASortDoes) {
  std::mt19937_64 random(1);
  for (const int bits : {1, 8, 25, 64}) {
    std::vector<std::uint64_t> keys;
    for (int i = 0; i < 1000; ++i) keys.push_back(random() >> (64 - bits));
    const std::set<std::uint64_t> sorted(keys.begin(), keys.end());
    CellRanking ranking;

    ranking.rank(keys);

    EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), ranking.distinct_keys().begin(),
                           ranking.distinct_keys().end()));
    for (std::size_t i = 0; i < keys.size(); ++i) {
      EXPECT_EQ(ranking.distinct_keys()[ranking.rank_of_item()[i]], keys[i]);
    }
  }
}

TEST(VoxelGrid, PutsPointsOfOneCellIntoOneVoxel) {
  const PointSet points = random_points(3000, 0.2F, 2);
  const VoxelOptions options{.size_m = 0.02F, .viewpoint = Viewpoint::multiple};
  VoxelGrid grid;

  Voxeliser().voxelise(points, options, grid);

  std::map<Cell, std::set<std::uint32_t>> voxels_of_cell;
  const auto voxel = voxel_of_point(grid);
  ASSERT_EQ(voxel.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    voxels_of_cell[metric_cell(points, i, options.size_m)].insert(voxel[i]);
  }
  EXPECT_EQ(voxels_of_cell.size(), grid.size());
  for (const auto& [cell, voxels] : voxels_of_cell) EXPECT_EQ(voxels.size(), 1U);
}

TEST(VoxelGrid, AveragesThePointsOfAVoxel) {
  const PointSet points = random_points(500, 0.2F, 3);
  VoxelGrid grid;

  Voxeliser().voxelise(points, {.size_m = 0.05F}, grid);

  const auto voxel = voxel_of_point(grid);
  std::vector<Eigen::Vector3d> sum(grid.size(), Eigen::Vector3d::Zero());
  std::vector<double> count(grid.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum[voxel[i]] += Eigen::Vector3d(points.x[i], points.y[i], points.z[i]);
    count[voxel[i]] += 1;
  }
  for (std::size_t v = 0; v < grid.size(); ++v) {
    EXPECT_TRUE(grid.centroid[v].cast<double>().isApprox(sum[v] / count[v], 1e-5));
  }
}

TEST(VoxelGrid, GrowsVoxelsWithTheDistanceForOneViewpoint) {
  // Two pairs of points 20 mm apart, one at 1 m, one at 10 m.
  PointSet points;
  points.x = {0.001F, 0.021F, 0.001F, 0.021F};
  points.y = {0.001F, 0.001F, 0.001F, 0.001F};
  points.z = {1, 1, 10, 10};
  points.index = {0, 1, 2, 3};
  VoxelGrid single, multiple;

  Voxeliser().voxelise(points, {.size_m = 0.01F, .viewpoint = Viewpoint::single}, single);
  Voxeliser().voxelise(points, {.size_m = 0.01F, .viewpoint = Viewpoint::multiple}, multiple);

  EXPECT_EQ(single.size(), 3U);
  EXPECT_EQ(multiple.size(), 4U);
}

class VoxelNeighbours : public testing::TestWithParam<std::pair<Neighbourhood, int>> {};

TEST_P(VoxelNeighbours, AreThoseOfBruteForce) {
  const auto [neighbourhood, most_axes] = GetParam();
  const PointSet points = random_points(2000, 0.2F, 4);
  const VoxelOptions options{.size_m = 0.02F, .viewpoint = Viewpoint::multiple};
  VoxelGrid grid;
  Voxeliser().voxelise(points, options, grid);
  NeighbourLists neighbours;

  find_voxel_neighbours(grid, neighbourhood, neighbours);

  std::vector<Cell> cell(grid.size());
  const auto voxel = voxel_of_point(grid);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cell[voxel[i]] = metric_cell(points, i, options.size_m);
  }
  for (std::uint32_t v = 0; v < grid.size(); ++v) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t u = 0; u < grid.size(); ++u) {
      int distance = 0;
      int axes = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        distance = std::max(distance, std::abs(cell[u][axis] - cell[v][axis]));
        axes += cell[u][axis] != cell[v][axis] ? 1 : 0;
      }
      if (distance == 1 && axes <= most_axes) expected.push_back(u);
    }
    EXPECT_TRUE(
        std::equal(expected.begin(), expected.end(), neighbours[v].begin(), neighbours[v].end()));
  }
}

// Section 2.1.2.1: 6, 18 and 26 neighbours.
INSTANTIATE_TEST_SUITE_P(FacesEdgesAndCorners, VoxelNeighbours,
                         testing::Values(std::pair{Neighbourhood::faces, 1},
                                         std::pair{Neighbourhood::edges, 2},
                                         std::pair{Neighbourhood::corners, 3}));

}  // namespace
}  // namespace cleave::segmentation
