// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_clustering.hpp"

#include <algorithm>
#include <cmath>

#include "segmentation/math/multiversion.hpp"
#include "segmentation/math/simd.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::uint32_t few_sweeps = 3;  // each cell is in the right window from the first on
constexpr float window = 0.9F;           // half an edge, in seed spacings
constexpr float max_window_cells = 10;   // half an edge
constexpr std::size_t lanes = 8;         // cells, of a row, that are worked on at once at most
constexpr float max_distance = 1e4F;     // nothing is as far as an empty cell
static_assert(max_window_cells + lanes < CellImage::border, "windows reach into the border");

// A window of cells, from the first one of its first row on.
struct Window {
  const float *x, *y, *z, *normal_x, *normal_y, *normal_z;
  float* distance;
  std::uint32_t* owner;
  std::size_t columns, rows, stride;
};

struct Claim {
  float x, y, z, normal_x, normal_y, normal_z;
  std::uint32_t number;
};

CLEAVE_MULTIVERSION
void claim_window(const Window& w, const Claim& c, float per_metre, float normal_weight) {
  for (std::size_t row = 0; row < w.rows; ++row) {
    const std::size_t begin = row * w.stride;
    for (std::size_t i = begin; i < begin + w.columns; i += lanes) {
      Float8 dx, dy, dz, normal_x, normal_y, normal_z, nearest;
      Int8 owner;
      load(w.x + i, dx);
      load(w.y + i, dy);
      load(w.z + i, dz);
      load(w.normal_x + i, normal_x);
      load(w.normal_y + i, normal_y);
      load(w.normal_z + i, normal_z);
      load(w.distance + i, nearest);
      load(w.owner + i, owner);
      dx -= c.x;
      dy -= c.y;
      dz -= c.z;
      const Float8 cosine = normal_x * c.normal_x + normal_y * c.normal_y + normal_z * c.normal_z;
      Float8 length = dx * dx + dy * dy + dz * dz;
      square_root(length);
      const Float8 distance = normal_weight * (1 - cosine) + per_metre * length;
      const Int8 nearer = distance < nearest;
      store(Float8(nearer ? distance : nearest), w.distance + i);
      store(Int8(nearer ? Int8{} + static_cast<std::int32_t>(c.number) : owner), w.owner + i);
    }
  }
}

}  // namespace

void CellClusterer::plant_seeds(const CellImage& cells) {
  centre_.clear();
  for (const std::uint32_t i : seeds_) {
    const std::size_t row = i / cells.stride - CellImage::border;
    const std::size_t column = i % cells.stride - CellImage::border;
    centre_.push_back({.x = cells.x[i],
                       .y = cells.y[i],
                       .z = cells.z[i],
                       .normal_x = cells.normal_x[i],
                       .normal_y = cells.normal_y[i],
                       .normal_z = cells.normal_z[i],
                       .column = static_cast<float>(column),
                       .row = static_cast<float>(row),
                       .cells = 1});
  }
}

void CellClusterer::assign_cells(const CellImage& cells, const SupervoxelOptions& options,
                                 std::vector<std::uint32_t>& owner) {
  distance_.assign(cells.size(), max_distance);
  owner.assign(cells.size(), no_owner);
  const float per_metre = options.spatial_weight / options.seed_spacing_m;
  const float reach_at_1_m = window * options.seed_spacing_m / cells.pitch;
  const auto last_row = static_cast<float>(cells.rows - 1);
  for (std::uint32_t s = 0; s < centre_.size(); ++s) {
    const Centre& c = centre_[s];
    const float reach = std::clamp(reach_at_1_m / c.z, 1.0F, max_window_cells);
    const auto top = static_cast<std::uint32_t>(std::max(c.row - reach, 0.0F));
    const auto bottom = static_cast<std::uint32_t>(std::min(c.row + reach, last_row));
    // Columns may lie in the border, on either side; nothing there is claimed.
    const auto left = static_cast<std::ptrdiff_t>(std::floor(c.column - reach));
    const auto columns = static_cast<std::size_t>(c.column + reach - static_cast<float>(left)) + 1;
    const std::size_t first = cells.row_begin(top) + static_cast<std::size_t>(left);
    claim_window({.x = &cells.x[first],
                  .y = &cells.y[first],
                  .z = &cells.z[first],
                  .normal_x = &cells.normal_x[first],
                  .normal_y = &cells.normal_y[first],
                  .normal_z = &cells.normal_z[first],
                  .distance = &distance_[first],
                  .owner = &owner[first],
                  .columns = (columns + lanes - 1) / lanes * lanes,
                  .rows = std::size_t{bottom - top} + 1,
                  .stride = cells.stride},
                 {c.x, c.y, c.z, c.normal_x, c.normal_y, c.normal_z, s}, per_metre,
                 options.normal_weight);
  }
}

void CellClusterer::move_centres(const CellImage& cells, const std::vector<std::uint32_t>& owner) {
  sum_.assign(centre_.size(), Centre{});
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    for (std::uint32_t column = 0; column < cells.columns; ++column) {
      const std::size_t i = begin + column;
      if (owner[i] == no_owner) continue;
      Centre& sum = sum_[owner[i]];
      sum.x += cells.x[i];
      sum.y += cells.y[i];
      sum.z += cells.z[i];
      sum.normal_x += cells.normal_x[i];
      sum.normal_y += cells.normal_y[i];
      sum.normal_z += cells.normal_z[i];
      sum.column += static_cast<float>(column);
      sum.row += static_cast<float>(row);
      sum.cells += 1;
    }
  }
  for (std::size_t s = 0; s < centre_.size(); ++s) {
    const Centre& sum = sum_[s];
    if (sum.cells == 0) continue;
    const float share = 1 / sum.cells;
    const float length = std::sqrt(sum.normal_x * sum.normal_x + sum.normal_y * sum.normal_y +
                                   sum.normal_z * sum.normal_z);
    const float scale = length > 0 ? 1 / length : 0;
    centre_[s] = {.x = sum.x * share,
                  .y = sum.y * share,
                  .z = sum.z * share,
                  .normal_x = sum.normal_x * scale,
                  .normal_y = sum.normal_y * scale,
                  .normal_z = sum.normal_z * scale,
                  .column = sum.column * share,
                  .row = sum.row * share,
                  .cells = sum.cells};
  }
}

std::uint32_t CellClusterer::cluster(const CellImage& cells, const SupervoxelOptions& options,
                                     std::vector<std::uint32_t>& owner) {
  seed_selector_.select(cells, options.seed_spacing_m, options.min_seed_voxels, seeds_);
  plant_seeds(cells);
  assign_cells(cells, options, owner);
  const std::uint32_t sweeps = options.sweeps > 0 ? options.sweeps : few_sweeps;
  for (std::uint32_t sweep = 1; sweep < sweeps; ++sweep) {
    move_centres(cells, owner);
    assign_cells(cells, options, owner);
  }
  return static_cast<std::uint32_t>(centre_.size());
}

}  // namespace cleave::segmentation
