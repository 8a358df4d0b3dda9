// SPDX-License-Identifier: BSD-3-Clause
// An organised cloud as planes of numbers with a border.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "segmentation/cloud_view.hpp"

namespace cleave::segmentation {

// Where pixels lie in a plane: row-major inside a border, so that no window around a pixel ends
// early and whole blocks of pixels can be worked on at once.
struct ImageLayout {
  static constexpr std::uint32_t border = 24;  // pixels on every side

  std::uint32_t width = 0, height = 0;
  std::uint32_t shift_x = 0;  // pixels that are left free between the border and the first column
  std::uint32_t stride = 0;   // from one row to the next

  [[nodiscard]] std::size_t size() const { return std::size_t{height + 2 * border} * stride; }
  // Of the pixel in column 0.
  [[nodiscard]] std::size_t row_begin(std::uint32_t row) const {
    return std::size_t{row + border} * stride + border + shift_x;
  }
  friend bool operator==(const ImageLayout&, const ImageLayout&) = default;
};

struct PixelImage {
  static constexpr float no_depth = std::numeric_limits<float>::infinity();
  static constexpr std::uint32_t no_segment = std::numeric_limits<std::uint32_t>::max();

  ImageLayout layout;
  std::vector<float> x, y, z;          // metres; (0, 0, no_depth) where nothing was measured
  std::vector<std::uint32_t> segment;  // no_segment where nothing was measured

  // Makes room, with nothing measured in the border. What is inside is undefined.
  void lay_out(const ImageLayout& wanted);
};

// Copies a row of the cloud's points, cut to +-max_coordinate_m, into an image that is laid out for
// it. What is not in front of the sensor is left out like what was not measured; returns how many
// measured points that are.
[[nodiscard]] std::size_t load_row(const CloudView& cloud, std::uint32_t row, PixelImage& image);

}  // namespace cleave::segmentation
