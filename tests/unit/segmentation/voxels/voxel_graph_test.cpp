// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/voxel_graph.hpp"

#include <gtest/gtest.h>

namespace cleave::segmentation {
namespace {

// Voxels 1 cm apart along x; those left of the middle face left by the slope, the others right.
// slope > 0: a roof.
struct Row {
  std::vector<Surfel> voxels;
  NeighbourLists neighbours;

  Row(std::uint32_t count, float slope) {
    neighbours.begin.push_back(0);
    for (std::uint32_t i = 0; i < count; ++i) {
      const float lean = 2 * i + 1 < count ? -slope : slope;
      voxels.push_back({Eigen::Vector3f(0.01F * static_cast<float>(i), 0, 1),
                        Eigen::Vector3f(lean, 0, -1).normalized()});
      if (i > 0) neighbours.neighbour.push_back(i - 1);
      if (i + 1 < count) neighbours.neighbour.push_back(i + 1);
      neighbours.begin.push_back(static_cast<std::uint32_t>(neighbours.neighbour.size()));
    }
  }
};

std::vector<std::uint8_t> convex_voxels(const Row& row) {
  std::vector<std::uint8_t> is_convex;
  find_convex_voxels(row.voxels, row.neighbours, is_convex);
  return is_convex;
}

// Signs for voxel 1 of a roof of four: the left neighbour leans left, away (+1); the right one
// right, away (+1). Of a valley both lean towards it.
TEST(Equation4_15, CallsAVoxelConvexIfMostNeighboursLeanAway) {
  EXPECT_EQ(convex_voxels(Row(4, 0.5F)), (std::vector<std::uint8_t>{0, 1, 1, 0}));
  EXPECT_EQ(convex_voxels(Row(4, -0.5F)), (std::vector<std::uint8_t>{1, 0, 0, 1}));
}

TEST(Equation4_15, CallsFlatAndLoneVoxelsNotConvex) {
  EXPECT_EQ(convex_voxels(Row(3, 0)), (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(convex_voxels(Row(1, 0.5F)), (std::vector<std::uint8_t>{0}));
}

TEST(Equation4_16, WeighsConcaveEdgesByNormalsAndCurvatures) {
  const SvcOptions options{.normal_sigma = 10, .curvature_sigma = 1e4F};
  const Surfel up{Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ()};
  const Surfel side{Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitX()};

  // |n_i - n_j|^2 = 2; (c_i c_j)^2 = 0.02^2 = 4e-4.
  EXPECT_FLOAT_EQ(concave_voxel_weight(up, side, 0.1F, 0.2F, options), 1.0F / 21 / 5);
  EXPECT_FLOAT_EQ(concave_voxel_weight(up, up, 0, 0.3F, options), 1);
}

TEST(Equation4_16, WeighsEdgesBetweenConvexVoxelsOne) {
  const Row roof(4, 0.5F);
  std::vector<SupervoxelEdge> edges;

  VoxelGraphBuilder().build(roof.voxels, {0.1F, 0.1F, 0.1F, 0.1F}, roof.neighbours, {}, edges);

  ASSERT_EQ(edges.size(), 3U);
  EXPECT_FALSE(edges[0].convex);
  EXPECT_LT(edges[0].weight, 1);
  EXPECT_TRUE(edges[1].convex);
  EXPECT_EQ(edges[1].weight, 1);
  EXPECT_EQ(edges[2].first, 2U);
  EXPECT_EQ(edges[2].second, 3U);
}

}  // namespace
}  // namespace cleave::segmentation
