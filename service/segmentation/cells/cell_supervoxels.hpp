// SPDX-License-Identifier: BSD-3-Clause
// The plane of every supervoxel, from sums over its cells.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/cells/cell_image.hpp"
#include "segmentation/graph/supervoxels.hpp"

namespace cleave::segmentation {

// Regression of 1/z on (u, v) as for cells (see cell_normals.hpp). Where cells lie on a line, their
// mean normal stands in.
class CellSupervoxelFitter {
 public:
  // `supervoxel`: of a cell, CellClusterer::no_owner for empty ones. `from_points`: each cell
  // counts as often as it has points; otherwise once. Fills surfels and point counts and leaves
  // `of_voxel` alone.
  void fit(const CellImage& cells, const std::vector<std::uint32_t>& supervoxel, std::size_t count,
           bool from_points, Supervoxels& supervoxels);

 private:
  struct Sums {
    double points = 0, weight = 0;
    double x = 0, y = 0, z = 0;
    double u = 0, v = 0, q = 0, uu = 0, uv = 0, vv = 0, uq = 0, vq = 0;  // q = 1/z
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  };
  std::vector<Sums> sums_;
};

}  // namespace cleave::segmentation
