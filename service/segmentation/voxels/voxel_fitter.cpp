// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/voxel_fitter.hpp"

#include <cmath>
#include <numbers>

#include "segmentation/voxels/voxel_neighbours.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::size_t plane_neighbours = 7;  // of a voxel in a plane, which has 8 and more
constexpr float step = std::numbers::sqrt2_v<float>;
constexpr float max_growth = 1024;      // 6 m
constexpr std::size_t min_voxels = 64;  // fewer are no surface, however they lie

double points_with_neighbours(const VoxelGrid& grid, const NeighbourLists& neighbours) {
  double points = 0;
  for (std::size_t v = 0; v < grid.size(); ++v) {
    if (neighbours[v].size() >= plane_neighbours) points += grid.moments[v].n;
  }
  return points;
}

}  // namespace

bool VoxelFitter::holds_together(const PointSet& points, const VoxelOptions& options, float growth,
                                 VoxelGrid& grid, NeighbourLists& neighbours) {
  VoxelOptions grown = options;
  grown.size_m *= growth;
  voxeliser_.voxelise(points, grown, grid);
  find_voxel_neighbours(grid, Neighbourhood::corners, neighbours);
  return 2 * points_with_neighbours(grid, neighbours) > static_cast<double>(points.size());
}

float VoxelFitter::grow(const PointSet& points, const VoxelOptions& options, VoxelGrid& grid,
                        NeighbourLists& neighbours) {
  const auto holds_at = [&](float growth) {
    return holds_together(points, options, growth, grid, neighbours);
  };
  float growth = 1;
  if (holds_at(growth)) return growth;
  do growth *= 2;
  while (growth <= max_growth && !holds_at(growth) && grid.size() >= min_voxels);
  if (growth > max_growth || grid.size() < min_voxels) {
    growth = 1;
  } else if (holds_at(growth / step)) {
    return growth / step;
  }
  (void)holds_at(growth);
  return growth;
}

float VoxelFitter::voxelise(const PointSet& points, const VoxelOptions& options, VoxelGrid& grid,
                            NeighbourLists& neighbours) {
  if (!options.follow_spacing || options.size_m != VoxelOptions{}.size_m) {
    voxeliser_.voxelise(points, options, grid);
    find_voxel_neighbours(grid, options.neighbourhood, neighbours);
    return 1;
  }
  const float growth = grow(points, options, grid, neighbours);
  if (options.neighbourhood != Neighbourhood::automatic &&
      options.neighbourhood != Neighbourhood::corners) {
    find_voxel_neighbours(grid, options.neighbourhood, neighbours);
  }
  return growth;
}

}  // namespace cleave::segmentation
