#include "segmentation/mixed_windows.hpp"

#include <algorithm>

#include "segmentation/multiversion.hpp"

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
void merge_shifted(const std::uint8_t* __restrict marks, std::size_t shift, std::size_t count,
                   std::uint8_t* __restrict result) {
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = static_cast<std::uint8_t>(marks[i] | marks[i - shift] | marks[i + shift]);
  }
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

// In steps that double: marks that have spread by r on both sides spread by up to r more at once.
void MixedWindowFinder::spread_marks(std::size_t step, std::uint32_t distance) {
  for (std::uint32_t done = 0; done < distance;) {
    const std::uint32_t further = std::min(std::max(done, 1U), distance - done);
    const std::size_t shift = further * step;
    spread_.assign(mixed_.begin(), mixed_.end());
    if (mixed_.size() > 2 * shift) {
      merge_shifted(mixed_.data() + shift, shift, mixed_.size() - 2 * shift,
                    spread_.data() + shift);
    }
    mixed_.swap(spread_);
    done += further;
  }
}

void MixedWindowFinder::list_spans(const TileGrid& grid, const ImageLayout& layout,
                                   std::vector<PixelSpan>& spans) const {
  spans.clear();
  const auto inside = [](std::size_t tile, std::uint32_t edge, std::uint32_t shift,
                         std::uint32_t size) {
    const std::size_t pixel = tile * edge;
    return std::min<std::size_t>(pixel > shift ? pixel - shift : 0, size);
  };
  for (std::uint32_t y = 0; y < layout.height; ++y) {
    const std::uint8_t* mixed =
        mixed_.data() + grid.first + (y + grid.shift_y) / grid.edge * grid.stride;
    for (std::size_t c = 0; c < grid.columns;) {
      if (mixed[c] == 0) {
        ++c;
        continue;
      }
      const std::size_t first = c;
      while (c < grid.columns && mixed[c] != 0) ++c;
      spans.push_back({layout.row_begin(y) + inside(first, grid.edge, grid.shift_x, layout.width),
                       layout.row_begin(y) + inside(c, grid.edge, grid.shift_x, layout.width)});
    }
  }
}

void MixedWindowFinder::find(const TileGrid& grid, std::span<const std::uint32_t> segment,
                             std::uint32_t radius, const ImageLayout& layout,
                             std::vector<PixelSpan>& spans) {
  fill_empty_tiles(grid, segment);
  // Up to the grid's last row and column: what lies behind is no neighbour.
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    const std::size_t begin = grid.first + row * grid.stride;
    const std::size_t below = row + 1 < grid.rows ? grid.stride : 0;
    mark_differences(filled_.data() + begin, below, grid.columns - 1, mixed_.data() + begin);
    const std::size_t last = begin + grid.columns - 1;
    if (filled_[last] != filled_[last + below]) mixed_[last] = 1;
  }
  // A window with both tiles of a pair holds the marked one.
  const std::uint32_t tiles = (radius + grid.edge - 1) / grid.edge;
  spread_marks(1, tiles);
  spread_marks(grid.stride, tiles);
  list_spans(grid, layout, spans);
}

}  // namespace cleave::segmentation
