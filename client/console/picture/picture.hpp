// SPDX-License-Identifier: BSD-3-Clause
// What people see of a labelled cloud: depth as grey, segments as colours over it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "console/picture/depth_image.hpp"

namespace cleave {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Rgb&) const = default;
};

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<Rgb> pixels;  // row-major
  [[nodiscard]] const Rgb& at(std::uint32_t column, std::uint32_t row) const {
    return pixels[std::size_t{row} * width + column];
  }
};

// The colour of a label, 1 or more. Hues step by the golden ratio: labels that follow each other
// differ most, and a label has the same colour in every picture.
[[nodiscard]] Rgb label_colour(std::uint16_t label);

// Near is bright, far is dark, no measurement is black.
[[nodiscard]] Picture depth_picture(const DepthImage& image);

// The same with every segment tinted in its label's colour, darker along its borders.
[[nodiscard]] Picture segment_picture(const DepthImage& image);

// Green where `found`, one label a pixel, is the image's own label, red where it is another, and
// grey where the image has none (Figure 5.7b of the thesis); darker with depth.
[[nodiscard]] Picture difference_picture(const DepthImage& truth,
                                         std::span<const std::uint16_t> found);

// Both of the same height.
[[nodiscard]] Picture side_by_side(const Picture& left, const Picture& right);

// Both of the same width.
[[nodiscard]] Picture one_above_other(const Picture& top, const Picture& bottom);

}  // namespace cleave
