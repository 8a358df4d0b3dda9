// SPDX-License-Identifier: BSD-3-Clause
// Voxels that are no finer than the cloud: between points farther apart, none would have a
// neighbour, and every one would end as a segment of its own.
#pragma once

#include "segmentation/math/neighbour_lists.hpp"
#include "segmentation/options.hpp"
#include "segmentation/points/point_set.hpp"
#include "segmentation/voxels/voxel_grid.hpp"

namespace cleave::segmentation {

// Surfaces hold together if most points lie in voxels with as many occupied neighbours as on a
// plane. Unless they do, voxels grow, in steps of the square root of 2, until they do: a surface of
// points s apart gets voxels of about 1 s to 2 s, in metres and in the space of one viewpoint
// alike. Where no size helps, as with points along a line, the size that was asked for stays.
class VoxelFitter {
 public:
  // Fills `grid` and its `neighbours`, of options.neighbourhood. Returns how many times larger than
  // `options.size_m` voxels are: 1 unless options.follow_spacing holds and size_m has its default.
  float voxelise(const PointSet& points, const VoxelOptions& options, VoxelGrid& grid,
                 NeighbourLists& neighbours);

 private:
  // As voxelise(), where voxels may grow; `neighbours` are all 26.
  [[nodiscard]] float grow(const PointSet& points, const VoxelOptions& options, VoxelGrid& grid,
                           NeighbourLists& neighbours);
  // Whether surfaces hold together with voxels `growth` times as large.
  [[nodiscard]] bool holds_together(const PointSet& points, const VoxelOptions& options,
                                    float growth, VoxelGrid& grid, NeighbourLists& neighbours);

  Voxeliser voxeliser_;
};

}  // namespace cleave::segmentation
