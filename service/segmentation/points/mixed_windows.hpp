// SPDX-License-Identifier: BSD-3-Clause
// Where in an image a window can hold more than one segment.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/points/pixel_image.hpp"

namespace cleave::segmentation {

// Pixels side by side, as indices of an image's planes.
struct PixelSpan {
  std::size_t begin = 0, end = 0;
};

// Squares of edge x edge pixels that share one segment, or nearly. The first tile's first pixel
// stands `shift_x` left of and `shift_y` above the image's.
struct TileGrid {
  std::uint32_t edge = 1, shift_x = 0, shift_y = 0;
  std::uint32_t columns = 0, rows = 0;
  std::size_t stride = 0, first = 0;  // index of row r, column c: first + r * stride + c
};

class MixedWindowFinder {
 public:
  // For a start no tile is mixed.
  std::vector<std::uint8_t>& clear_marks(std::size_t tiles);

  // `segment`: of every tile, PixelImage::no_segment where it is empty. Tiles marked above hold
  // several segments. Leaves out only pixels around which a window of (2 radius + 1)^2 pixels holds
  // one segment or none.
  void find(const TileGrid& grid, std::span<const std::uint32_t> segment, std::uint32_t radius,
            const ImageLayout& layout, std::vector<PixelSpan>& spans);

 private:
  void fill_empty_tiles(const TileGrid& grid, std::span<const std::uint32_t> segment);
  void merge_rows(const TileGrid& grid, std::uint32_t y, std::uint32_t radius);
  void list_spans(const TileGrid& grid, std::uint32_t y, std::uint32_t radius,
                  const ImageLayout& layout, std::vector<PixelSpan>& spans) const;

  std::vector<std::uint32_t> filled_;
  std::vector<std::uint8_t> mixed_, row_;
};

}  // namespace cleave::segmentation
