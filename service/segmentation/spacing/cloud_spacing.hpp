// SPDX-License-Identifier: BSD-3-Clause
// What a frame tells of how densely its surfaces are sampled.
#pragma once

#include <cstddef>

namespace cleave::segmentation {

struct CloudSpacing {
  std::size_t points = 0;    // measured
  double points_a_cell = 0;  // mean, of a cell or a voxel
  double cell_m = 0;  // edge of a cell or a voxel, at the (harmonic) mean depth if it grows with it
  float growth = 1;   // of voxels: how many times larger than asked for; see VoxelFitter
};

}  // namespace cleave::segmentation
