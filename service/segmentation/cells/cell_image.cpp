// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_image.hpp"

#include <algorithm>
#include <cmath>

#include "segmentation/math/multiversion.hpp"
#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {
namespace {

constexpr float front_layer = 1.015F;  // times the nearest depth in the cell
// No more, so that the middle of a cell that reaches out of the image is still in its border.
constexpr std::uint32_t max_edge_px = 2 * ImageLayout::border;

CLEAVE_MULTIVERSION
void take_nearest(const float* __restrict z, std::size_t count, float* __restrict nearest) {
  for (std::size_t i = 0; i < count; ++i) nearest[i] = z[i] < nearest[i] ? z[i] : nearest[i];
}

CLEAVE_MULTIVERSION
void add_near_points(const float* __restrict x, const float* __restrict y,
                     const float* __restrict z, const float* __restrict limit, std::size_t count,
                     float* __restrict sum_x, float* __restrict sum_y, float* __restrict sum_z,
                     float* __restrict points) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool counts = z[i] <= limit[i];
    sum_x[i] += counts ? x[i] : 0;
    sum_y[i] += counts ? y[i] : 0;
    sum_z[i] += counts ? z[i] : 0;
    points[i] += counts ? 1.0F : 0.0F;
  }
}

// Sums over each `edge` neighbours; three is what a depth camera's pixels come to.
void add_up_columns(const std::vector<float>& column, std::uint32_t edge, std::size_t count,
                    float* sum) {
  const float* from = column.data();
  if (edge == 3) {
    for (std::size_t i = 0; i < count; ++i)
      sum[i] = from[3 * i] + from[3 * i + 1] + from[3 * i + 2];
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    float total = 0;
    for (std::uint32_t k = 0; k < edge; ++k) total += *from++;
    sum[i] = total;
  }
}

CLEAVE_MULTIVERSION
void sums_to_means(std::size_t count, const float* __restrict points, float* __restrict x,
                   float* __restrict y, float* __restrict z, float* __restrict u,
                   float* __restrict v, float* __restrict inverse_depth) {
  constexpr float nowhere = CellImage::nowhere;
  for (std::size_t i = 0; i < count; ++i) {
    const bool occupied = points[i] > 0;
    const float share = 1 / (occupied ? points[i] : 1.0F);
    const float mean_x = x[i] * share;
    const float mean_y = y[i] * share;
    const float mean_z = z[i] * share;
    const float inverse = 1 / (occupied ? mean_z : 1.0F);
    x[i] = occupied ? mean_x : nowhere;
    y[i] = occupied ? mean_y : nowhere;
    z[i] = occupied ? mean_z : nowhere;
    u[i] = occupied ? mean_x * inverse : 0;
    v[i] = occupied ? mean_y * inverse : 0;
    inverse_depth[i] = occupied ? inverse : -nowhere;
  }
}

// From how many occupied cells does a coordinate not grow to the next one `step` away?
std::uint32_t backward_steps(const CellImage& cells, const std::vector<float>& coordinate,
                             std::size_t step) {
  std::uint32_t backward = 0;
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    for (std::size_t i = begin; i < begin + cells.columns; ++i) {
      const bool both = (cells.points[i] > 0) & (cells.points[i + step] > 0);
      backward += (both & !(coordinate[i] < coordinate[i + step])) ? 1U : 0U;
    }
  }
  return backward;
}

}  // namespace

void CellImager::lay_out(const CloudView& cloud, float grid_offset, CellImage& cells,
                         PixelImage& pixels) {
  const std::uint32_t edge = cells.edge;
  const std::uint32_t positions = edge * edge;
  const auto position = std::min(
      static_cast<std::uint32_t>(grid_offset * static_cast<float>(positions)), positions - 1);
  cells.shift_x = position % edge;
  cells.shift_y = position / edge;
  const std::uint32_t columns = (cloud.width + cells.shift_x + edge - 1) / edge;
  const std::uint32_t rows = (cloud.height + cells.shift_y + edge - 1) / edge;
  const std::uint32_t padded_width = columns * edge;
  pixels.lay_out({.width = cloud.width,
                  .height = cloud.height,
                  .shift_x = cells.shift_x,
                  .stride = padded_width + 2 * ImageLayout::border});
  for (auto* column : {&limit_m_, &sum_x_, &sum_y_, &sum_z_, &count_}) {
    column->resize(padded_width);
  }
  if (columns == cells.columns && rows == cells.rows) return;  // only the inside changes
  cells.columns = columns;
  cells.rows = rows;
  cells.stride = (columns + 2 * CellImage::border + 7) & ~7U;
  const std::size_t size = std::size_t{cells.stride} * (rows + 2 * CellImage::border);
  for (auto* coordinate : {&cells.x, &cells.y, &cells.z}) {
    coordinate->assign(size, CellImage::nowhere);
  }
  for (auto* ratio : {&cells.u, &cells.v}) ratio->assign(size, 0);
  cells.inverse_depth.assign(size, -CellImage::nowhere);
  cells.points.assign(size, 0);
}

void CellImager::sum_front_layer(const PixelImage& pixels, std::uint32_t first_row,
                                 std::uint32_t rows, const CellImage& cells) {
  const std::uint32_t edge = cells.edge;
  const std::size_t width = limit_m_.size();
  const std::size_t first = pixels.layout.row_begin(first_row) - cells.shift_x;
  std::fill(limit_m_.begin(), limit_m_.end(), PixelImage::no_depth);
  for (std::uint32_t row = 0; row < rows; ++row) {
    take_nearest(&pixels.z[first + std::size_t{row} * pixels.layout.stride], width,
                 limit_m_.data());
  }
  for (float* limit = limit_m_.data(); limit < limit_m_.data() + width; limit += edge) {
    const float nearest = *std::min_element(limit, limit + edge);
    // Not infinite, or cells without points would find that all of them are near enough.
    std::fill_n(limit, edge, std::min(nearest * front_layer, std::numeric_limits<float>::max()));
  }
  for (auto* sum : {&sum_x_, &sum_y_, &sum_z_, &count_}) std::fill(sum->begin(), sum->end(), 0.0F);
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::size_t begin = first + std::size_t{row} * pixels.layout.stride;
    add_near_points(&pixels.x[begin], &pixels.y[begin], &pixels.z[begin], limit_m_.data(), width,
                    sum_x_.data(), sum_y_.data(), sum_z_.data(), count_.data());
  }
}

void CellImager::store_row(std::uint32_t row, CellImage& cells) const {
  const std::size_t begin = cells.row_begin(row);
  const std::uint32_t columns = cells.columns;
  add_up_columns(sum_x_, cells.edge, columns, cells.x.data() + begin);
  add_up_columns(sum_y_, cells.edge, columns, cells.y.data() + begin);
  add_up_columns(sum_z_, cells.edge, columns, cells.z.data() + begin);
  add_up_columns(count_, cells.edge, columns, cells.points.data() + begin);
  sums_to_means(columns, cells.points.data() + begin, cells.x.data() + begin,
                cells.y.data() + begin, cells.z.data() + begin, cells.u.data() + begin,
                cells.v.data() + begin, cells.inverse_depth.data() + begin);
}

bool CellImager::gather(const CloudView& cloud, float size, float grid_offset, CellImage& cells,
                        PixelImage& pixels) {
  if (!cloud.organised()) return false;
  const float pitch = pitch_finder_.find(cloud);
  if (!(pitch > 0)) return false;
  const auto max_edge = static_cast<float>(std::min({cloud.width, cloud.height, max_edge_px}));
  cells.edge = static_cast<std::uint32_t>(std::clamp(std::round(size / pitch), 1.0F, max_edge));
  cells.pitch = pitch * static_cast<float>(cells.edge);
  lay_out(cloud, grid_offset, cells, pixels);

  std::size_t behind = 0;
  std::uint32_t next = 0;
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::uint32_t first = next;
    const std::uint32_t end = std::min((row + 1) * cells.edge - cells.shift_y, cloud.height);
    for (; next < end; ++next) behind += load_row(cloud, next, pixels);
    sum_front_layer(pixels, first, end - first, cells);
    store_row(row, cells);
  }
  // A point that is far off where its pixel looks stands alone and does no harm.
  const std::size_t allowed = max_strays(std::size_t{cells.columns} * cells.rows);
  return behind <= max_strays(cloud.size()) && backward_steps(cells, cells.u, 1) <= allowed &&
         backward_steps(cells, cells.v, cells.stride) <= allowed;
}

}  // namespace cleave::segmentation
