// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/voxel_grid.hpp"

#include <algorithm>

#include "segmentation/math/portable_math.hpp"

namespace cleave::segmentation {
namespace {

// How much of VoxelOptions::grid_offset each axis is shifted by; unequal, so that no two offsets
// give the same grid along a diagonal.
constexpr std::array<float, 3> offset_share = {1.0F, 0.7F, 0.4F};

// With one viewpoint, points closer than this count as this close: ln z has no lower end.
constexpr float min_depth_m = 1e-3F;

void accumulate_moments(const PointSet& points, VoxelGrid& grid) {
  grid.moments.assign(grid.size(), Moments{});
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    Moments sum;
    for (std::uint32_t i = grid.run_begin[run]; i < grid.run_begin[run + 1]; ++i) {
      sum.add_point(points.x[i], points.y[i], points.z[i]);
    }
    grid.moments[grid.run_voxel[run]] += sum;
  }

  grid.centroid.resize(grid.size());
  for (std::size_t v = 0; v < grid.size(); ++v) {
    grid.centroid[v] = grid.moments[v].mean().cast<float>();
  }
}

}  // namespace

void Voxeliser::find_cells(const PointSet& points, const VoxelOptions& options,
                           bool one_viewpoint) {
  const std::size_t n = points.size();
  for (auto& axis : cell_) axis.resize(n);
  const float per_cell = 1 / options.size_m;
  const float shift_x = options.grid_offset * offset_share[0];
  const float shift_y = options.grid_offset * offset_share[1];
  const float shift_z = options.grid_offset * offset_share[2];

  if (one_viewpoint) {
    for (std::size_t i = 0; i < n; ++i) {
      const float depth = std::max(points.z[i], min_depth_m);
      cell_[0][i] = cell_of(points.x[i] / depth * per_cell + shift_x);
      cell_[1][i] = cell_of(points.y[i] / depth * per_cell + shift_y);
      cell_[2][i] = cell_of(portable::log(depth) * per_cell + shift_z);
    }
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      cell_[0][i] = cell_of(points.x[i] * per_cell + shift_x);
      cell_[1][i] = cell_of(points.y[i] * per_cell + shift_y);
      cell_[2][i] = cell_of(points.z[i] * per_cell + shift_z);
    }
  }
}

void Voxeliser::find_runs(VoxelGrid& grid) {
  auto& [x, y, z] = cell_;
  grid.run_begin.clear();
  for (std::uint32_t i = 0; i < x.size(); ++i) {
    const std::size_t run = grid.run_begin.size();
    if (run > 0 && x[i] == x[run - 1] && y[i] == y[run - 1] && z[i] == z[run - 1]) continue;
    grid.run_begin.push_back(i);
    x[run] = x[i];
    y[run] = y[i];
    z[run] = z[i];
  }
  const std::size_t runs = grid.run_begin.size();
  grid.run_begin.push_back(static_cast<std::uint32_t>(x.size()));
  for (auto& axis : cell_) axis.resize(runs);
}

void Voxeliser::voxelise(const PointSet& points, const VoxelOptions& options, VoxelGrid& grid) {
  grid.one_viewpoint = options.viewpoint != Viewpoint::multiple;
  find_cells(points, options, grid.one_viewpoint);
  find_runs(grid);

  const auto& [x, y, z] = cell_;
  grid.packing = CellPacking::covering(x, y, z);
  run_key_.resize(x.size());
  for (std::size_t run = 0; run < x.size(); ++run) {
    run_key_[run] = grid.packing.key(x[run], y[run], z[run]);
  }
  ranking_.rank(run_key_);
  grid.key = ranking_.distinct_keys();
  grid.run_voxel = ranking_.rank_of_item();

  accumulate_moments(points, grid);
}

}  // namespace cleave::segmentation
