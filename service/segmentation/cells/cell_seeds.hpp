// SPDX-License-Identifier: BSD-3-Clause
// Where supervoxels start, on cells (Papon et al., CVPR 2013); see supervoxel_seeds.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/cells/cell_image.hpp"
#include "segmentation/math/cell_ranking.hpp"

namespace cleave::segmentation {

// One seed in every cube of a metric grid that holds enough cells: the cell nearest its middle.
class CellSeedSelector {
 public:
  // `seeds`: cells, one a cube, in the order of the cubes.
  void select(const CellImage& cells, float spacing_m, std::uint32_t min_cells,
              std::vector<std::uint32_t>& seeds);

 private:
  struct Cube {
    std::uint32_t cells = 0;
    std::uint32_t nearest_cell = 0;
    float nearest_squared_distance = 0;
  };
  void find_places(const CellImage& cells, std::uint32_t row, float cubes_per_m);
  void find_runs(const CellImage& cells, float spacing_m);
  void join_runs();

  // Cells side by side often share a cube: those are one run, counted as a cube of its own first.
  std::vector<Cube> run_;
  std::vector<std::int32_t> cube_x_, cube_y_, cube_z_;  // of a row's cells
  std::vector<float> squared_distance_;                 // of a row's cells to their cubes' middles
  std::vector<std::int32_t> x_, y_, z_;                 // cube of a run
  std::vector<std::uint64_t> key_;
  CellRanking ranking_;
  std::vector<Cube> cubes_;
};

}  // namespace cleave::segmentation
