// SPDX-License-Identifier: BSD-3-Clause
// Where supervoxels start (Papon et al., "Voxel Cloud Connectivity Segmentation", CVPR 2013).
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/surfel.hpp"
#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// One seed in every cell of a coarse metric grid that holds enough voxels: the voxel nearest the
// cell's middle. Cells with few voxels are noise or a neighbour's fringe.
class SeedSelector {
 public:
  // `seeds`: voxels, one a cell, in the order of the cells.
  void select(const std::vector<Surfel>& voxels, const SupervoxelOptions& options,
              std::vector<std::uint32_t>& seeds);

 private:
  struct Cell {
    std::uint32_t voxels = 0;
    std::uint32_t nearest_voxel = 0;
    float nearest_squared_distance = 0;
  };
  std::vector<std::int32_t> x_, y_, z_;  // cell of a voxel
  std::vector<std::uint64_t> key_;
  CellRanking ranking_;
  std::vector<Cell> cells_;
};

}  // namespace cleave::segmentation
