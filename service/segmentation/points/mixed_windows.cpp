// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/points/mixed_windows.hpp"

#include <algorithm>

#include "segmentation/math/multiversion.hpp"

namespace cleave::segmentation {
namespace {

CLEAVE_MULTIVERSION
void mark_differences(const std::uint32_t* __restrict segment, std::size_t stride,
                      std::size_t count, std::uint8_t* __restrict mixed) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool differs = segment[i] != segment[i + 1] || segment[i] != segment[i + stride];
    mixed[i] = static_cast<std::uint8_t>(mixed[i] | (differs ? 1 : 0));
  }
}

CLEAVE_MULTIVERSION
void merge(const std::uint8_t* __restrict marks, std::size_t count,
           std::uint8_t* __restrict result) {
  for (std::size_t i = 0; i < count; ++i)
    result[i] = static_cast<std::uint8_t>(result[i] | marks[i]);
}

}  // namespace

std::vector<std::uint8_t>& MixedWindowFinder::clear_marks(std::size_t tiles) {
  mixed_.assign(tiles, 0);
  return mixed_;
}

// A block of tiles with two segments has two neighbours that differ. That stays true when tiles
// without a segment are given any: here the last one before them.
void MixedWindowFinder::fill_empty_tiles(const TileGrid& grid,
                                         std::span<const std::uint32_t> segment) {
  filled_.assign(segment.begin(), segment.end());
  std::uint32_t last = PixelImage::no_segment;
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    const std::size_t begin = grid.first + row * grid.stride;
    for (std::size_t i = begin; i < begin + grid.columns; ++i) {
      last = filled_[i] == PixelImage::no_segment ? last : filled_[i];
      filled_[i] = last;
    }
  }
}

// Marks of all tiles that windows around a row of pixels reach into.
void MixedWindowFinder::merge_rows(const TileGrid& grid, std::uint32_t y, std::uint32_t radius) {
  const std::uint32_t middle = y + grid.shift_y;
  const std::uint32_t first = (middle - std::min(middle, radius)) / grid.edge;
  const std::uint32_t last = std::min((middle + radius) / grid.edge, grid.rows - 1);
  row_.assign(grid.columns, 0);
  for (std::uint32_t row = first; row <= last; ++row) {
    merge(mixed_.data() + grid.first + row * grid.stride, grid.columns, row_.data());
  }
}

void MixedWindowFinder::list_spans(const TileGrid& grid, std::uint32_t y, std::uint32_t radius,
                                   const ImageLayout& layout, std::vector<PixelSpan>& spans) const {
  const std::size_t row_begin = layout.row_begin(y);
  std::size_t listed = 0;  // columns of pixels
  for (std::size_t c = 0; c < grid.columns; ++c) {
    if (row_[c] == 0) continue;
    const std::size_t first = c * grid.edge;
    while (c < grid.columns && row_[c] != 0) ++c;
    const std::size_t left = first - std::min<std::size_t>(first, radius + grid.shift_x);
    const std::size_t begin = std::max(left, listed);
    const std::size_t end =
        std::min<std::size_t>(c * grid.edge + radius - grid.shift_x, layout.width);
    if (begin < end) spans.push_back({row_begin + begin, row_begin + end});
    listed = std::max(listed, end);
  }
}

void MixedWindowFinder::find(const TileGrid& grid, std::span<const std::uint32_t> segment,
                             std::uint32_t radius, const ImageLayout& layout,
                             std::vector<PixelSpan>& spans) {
  fill_empty_tiles(grid, segment);
  // A window with both tiles of a pair holds the marked one. Up to the grid's last row and column:
  // what lies behind is no neighbour.
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    const std::size_t begin = grid.first + row * grid.stride;
    const std::size_t below = row + 1 < grid.rows ? grid.stride : 0;
    mark_differences(filled_.data() + begin, below, grid.columns - 1, mixed_.data() + begin);
    const std::size_t last = begin + grid.columns - 1;
    if (filled_[last] != filled_[last + below]) mixed_[last] = 1;
  }
  spans.clear();
  for (std::uint32_t y = 0; y < layout.height; ++y) {
    merge_rows(grid, y, radius);
    list_spans(grid, y, radius, layout, spans);
  }
}

}  // namespace cleave::segmentation
