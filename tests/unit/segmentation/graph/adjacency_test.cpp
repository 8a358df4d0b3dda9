// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/adjacency.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

#include "segmentation/voxels/voxel_neighbours.hpp"
#include "tests/unit/segmentation/support/random_points.hpp"

namespace cleave::segmentation {
namespace {

TEST(AdjacencyFinder, CountsNeighbouringVoxelsAcrossEveryBorder) {
  VoxelGrid grid;
  NeighbourLists neighbours;
  Voxeliser().voxelise(random_points(2000, 0.2F, 7), {.size_m = 0.02F}, grid);
  find_voxel_neighbours(grid, Neighbourhood::corners, neighbours);
  std::mt19937 random(8);
  std::vector<std::uint32_t> supervoxel;
  for (std::size_t v = 0; v < grid.size(); ++v)
    supervoxel.push_back(static_cast<std::uint32_t>(random() % 30));
  std::vector<AdjacentPair> pairs;

  AdjacencyFinder().find(supervoxel, neighbours, pairs);

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> expected;
  for (std::uint32_t v = 0; v < grid.size(); ++v) {
    for (const std::uint32_t u : neighbours[v]) {
      if (v < u && supervoxel[v] != supervoxel[u]) {
        ++expected[std::minmax(supervoxel[v], supervoxel[u])];
      }
    }
  }
  ASSERT_EQ(pairs.size(), expected.size());
  auto next = expected.begin();
  for (const AdjacentPair& pair : pairs) {
    EXPECT_EQ(std::pair(pair.first, pair.second), next->first);
    EXPECT_EQ(pair.touching_voxels, next->second);
    ++next;
  }
}

}  // namespace
}  // namespace cleave::segmentation
