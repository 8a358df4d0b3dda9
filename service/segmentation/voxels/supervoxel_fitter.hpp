// SPDX-License-Identifier: BSD-3-Clause
// Supervoxels of voxels: where each lies, and how it is turned.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxels.hpp"
#include "segmentation/math/moments.hpp"
#include "segmentation/voxels/voxel_grid.hpp"

namespace cleave::segmentation {

// Fits a plane to each supervoxel; needs `of_voxel`, fills the rest.
class SupervoxelFitter {
 public:
  // `from_points`: through all its points; otherwise through its voxels, as in the thesis. One that
  // is too small for a plane gets the mean normal of its voxels.
  void fit(const VoxelGrid& grid, const std::vector<Surfel>& voxels, std::size_t count,
           bool from_points, Supervoxels& supervoxels);

 private:
  struct Sums {
    Moments moments;
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  };
  std::vector<Sums> sums_;
};

}  // namespace cleave::segmentation
