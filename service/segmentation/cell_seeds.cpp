#include "segmentation/cell_seeds.hpp"

#include "segmentation/cell_packing.hpp"

namespace cleave::segmentation {
namespace {

struct Place {
  std::int32_t cube = 0;
  float squared_distance = 0;  // of the coordinate from the cube's middle, in cubes
};

Place place_of(float coordinate) {
  const std::int32_t cube = cell_of(coordinate);
  const float off_middle = coordinate - static_cast<float>(cube) - 0.5F;
  return {cube, off_middle * off_middle};
}

}  // namespace

void CellSeedSelector::find_runs(const CellImage& cells, float spacing_m) {
  const float cubes_per_m = 1 / spacing_m;
  for (auto* axis : {&x_, &y_, &z_}) axis->clear();
  run_.clear();
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    bool row_begins = true;
    const auto begin = static_cast<std::uint32_t>(cells.row_begin(row));
    for (std::uint32_t i = begin; i < begin + cells.columns; ++i) {
      if (!cells.occupied(i)) continue;
      const Place x = place_of(cells.x[i] * cubes_per_m);
      const Place y = place_of(cells.y[i] * cubes_per_m);
      const Place z = place_of(cells.z[i] * cubes_per_m);
      const float squared_distance = x.squared_distance + y.squared_distance + z.squared_distance;
      if (row_begins || x.cube != x_.back() || y.cube != y_.back() || z.cube != z_.back()) {
        row_begins = false;
        x_.push_back(x.cube);
        y_.push_back(y.cube);
        z_.push_back(z.cube);
        run_.push_back(
            {.cells = 1, .nearest_cell = i, .nearest_squared_distance = squared_distance});
        continue;
      }
      Cube& run = run_.back();
      ++run.cells;
      if (squared_distance < run.nearest_squared_distance) {
        run.nearest_cell = i;
        run.nearest_squared_distance = squared_distance;
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
