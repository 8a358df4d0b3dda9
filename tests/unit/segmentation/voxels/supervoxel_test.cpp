// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "segmentation/math/plane_fit.hpp"
#include "segmentation/voxels/normals.hpp"
#include "segmentation/voxels/supervoxel_clustering.hpp"
#include "segmentation/voxels/voxel_neighbours.hpp"
#include "tests/unit/segmentation/support/random_points.hpp"

namespace cleave::segmentation {
namespace {

struct Voxels {
  VoxelGrid grid;
  NeighbourLists neighbours;
  std::vector<Surfel> surfels;

  Voxels(const PointSet& points, float size_m) {
    Voxeliser().voxelise(points, {.size_m = size_m, .viewpoint = Viewpoint::multiple}, grid);
    find_voxel_neighbours(grid, Neighbourhood::corners, neighbours);
    NormalEstimator().estimate(grid.centroid, neighbours, surfels);
  }
};

TEST(NormalEstimator, CountsEveryWayOfTwoStepsToACentroid) {
  const Voxels voxels(random_points(800, 0.2F, 5), 0.02F);
  const auto closed_ring = [&](std::uint32_t v) {
    std::vector<std::uint32_t> ring(voxels.neighbours[v].begin(), voxels.neighbours[v].end());
    ring.push_back(v);
    return ring;
  };

  for (std::uint32_t v = 0; v < voxels.surfels.size(); v += 7) {
    Moments moments;
    for (const std::uint32_t u : closed_ring(v)) {
      for (const std::uint32_t w : closed_ring(u)) {
        const Eigen::Vector3f& p = voxels.grid.centroid[w];
        moments.add_point(p.x(), p.y(), p.z());
      }
    }
    EXPECT_TRUE(voxels.surfels[v].normal.isApprox(fit_normal(moments), 1e-3F));
  }
}

TEST(SupervoxelClusterer, GivesEveryVoxelAConnectedSupervoxel) {
  const Voxels voxels(random_points(3000, 0.2F, 6), 0.01F);
  std::vector<std::uint32_t> of_voxel;

  const std::uint32_t count =
      SupervoxelClusterer().cluster(voxels.surfels, voxels.neighbours, {}, of_voxel);

  // Flood each supervoxel from its first voxel: nothing may be left over.
  std::vector<bool> reached(of_voxel.size(), false);
  std::set<std::uint32_t> seen;
  for (std::uint32_t v = 0; v < of_voxel.size(); ++v) {
    ASSERT_LT(of_voxel[v], count);
    if (!seen.insert(of_voxel[v]).second) continue;
    std::vector<std::uint32_t> stack = {v};
    reached[v] = true;
    while (!stack.empty()) {
      const std::uint32_t from = stack.back();
      stack.pop_back();
      for (const std::uint32_t u : voxels.neighbours[from]) {
        if (reached[u] || of_voxel[u] != of_voxel[v]) continue;
        reached[u] = true;
        stack.push_back(u);
      }
    }
  }
  EXPECT_EQ(seen.size(), count);
  EXPECT_EQ(std::count(reached.begin(), reached.end(), true), std::ssize(of_voxel));
}

TEST(SupervoxelClusterer, MakesAnIslandWithoutASeedASupervoxelOfItsOwn) {
  PointSet points;
  for (std::uint32_t i = 0; i < 400; ++i) {  // a plate of 20 x 20 voxels, and two voxels far off
    points.x.push_back(0.0105F * static_cast<float>(i % 20));
    points.y.push_back(0.0105F * static_cast<float>(i / 20));
    points.z.push_back(1);
  }
  for (const float x : {5.001F, 5.011F}) {
    points.x.push_back(x);
    points.y.push_back(0);
    points.z.push_back(1);
  }
  points.index.resize(points.x.size());
  const Voxels voxels(points, 0.01F);
  std::vector<std::uint32_t> of_voxel;

  (void)SupervoxelClusterer().cluster(voxels.surfels, voxels.neighbours, {}, of_voxel);

  std::set<std::uint32_t> plate, island;
  for (std::size_t v = 0; v < of_voxel.size(); ++v) {
    (voxels.grid.centroid[v].x() > 1 ? island : plate).insert(of_voxel[v]);
  }
  EXPECT_EQ(island.size(), 1U);
  EXPECT_GT(plate.size(), 20U);
  EXPECT_FALSE(plate.contains(*island.begin()));
}

}  // namespace
}  // namespace cleave::segmentation
