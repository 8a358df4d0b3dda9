// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_seeds.hpp"

#include <utility>

#include "segmentation/math/cell_packing.hpp"
#include "segmentation/math/multiversion.hpp"

namespace cleave::segmentation {
namespace {

// The cube of each coordinate, and how far that is from the cube's middle, squared, in cubes.
CLEAVE_MULTIVERSION
void add_places(const float* __restrict coordinate, std::size_t count, float cubes_per_m,
                std::int32_t* __restrict cube, float* __restrict squared_distance) {
  for (std::size_t i = 0; i < count; ++i) {
    cube[i] = cell_of(coordinate[i] * cubes_per_m);
    const float off_middle = coordinate[i] * cubes_per_m - static_cast<float>(cube[i]) - 0.5F;
    squared_distance[i] += off_middle * off_middle;
  }
}

}  // namespace

void CellSeedSelector::find_places(const CellImage& cells, std::uint32_t row, float cubes_per_m) {
  const std::size_t begin = cells.row_begin(row);
  squared_distance_.assign(cells.columns, 0);
  for (const auto& [coordinate, cube] :
       {std::pair(&cells.x, &cube_x_), std::pair(&cells.y, &cube_y_),
        std::pair(&cells.z, &cube_z_)}) {
    cube->resize(cells.columns);
    add_places(coordinate->data() + begin, cells.columns, cubes_per_m, cube->data(),
               squared_distance_.data());
  }
}

void CellSeedSelector::find_runs(const CellImage& cells, float spacing_m) {
  for (auto* axis : {&x_, &y_, &z_}) axis->clear();
  run_.clear();
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    find_places(cells, row, 1 / spacing_m);
    bool row_begins = true;
    const auto begin = static_cast<std::uint32_t>(cells.row_begin(row));
    for (std::uint32_t column = 0; column < cells.columns; ++column) {
      if (!cells.occupied(begin + column)) continue;
      const Cube own{1, begin + column, squared_distance_[column]};
      if (row_begins || cube_x_[column] != x_.back() || cube_y_[column] != y_.back() ||
          cube_z_[column] != z_.back()) {
        row_begins = false;
        x_.push_back(cube_x_[column]);
        y_.push_back(cube_y_[column]);
        z_.push_back(cube_z_[column]);
        run_.push_back(own);
        continue;
      }
      Cube& run = run_.back();
      ++run.cells;
      if (own.nearest_squared_distance < run.nearest_squared_distance) {
        run.nearest_cell = own.nearest_cell;
        run.nearest_squared_distance = own.nearest_squared_distance;
      }
    }
  }
}

void CellSeedSelector::join_runs() {
  const CellPacking packing = CellPacking::covering(x_, y_, z_);
  key_.resize(run_.size());
  for (std::size_t r = 0; r < run_.size(); ++r) key_[r] = packing.key(x_[r], y_[r], z_[r]);
  ranking_.rank(key_);

  cubes_.assign(ranking_.distinct_keys().size(), Cube{});
  for (std::size_t r = 0; r < run_.size(); ++r) {
    Cube& cube = cubes_[ranking_.rank_of_item()[r]];
    if (cube.cells == 0 || run_[r].nearest_squared_distance < cube.nearest_squared_distance) {
      cube.nearest_cell = run_[r].nearest_cell;
      cube.nearest_squared_distance = run_[r].nearest_squared_distance;
    }
    cube.cells += run_[r].cells;
  }
}

void CellSeedSelector::select(const CellImage& cells, float spacing_m, std::uint32_t min_cells,
                              std::vector<std::uint32_t>& seeds) {
  find_runs(cells, spacing_m);
  join_runs();
  seeds.clear();
  for (const Cube& cube : cubes_) {
    if (cube.cells >= min_cells) seeds.push_back(cube.nearest_cell);
  }
}

}  // namespace cleave::segmentation
