// SPDX-License-Identifier: BSD-3-Clause
// Smooths borders in the image: every pixel takes the commonest segment around it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/points/mixed_windows.hpp"
#include "segmentation/points/pixel_image.hpp"

namespace cleave::segmentation {

class ModeFilter {
 public:
  static constexpr std::uint32_t max_radius = 20;

  // Window of (2 radius + 1)^2 pixels; only those count that are within `depth_gate_m` of the
  // middle's depth. Among equally common segments the pixel's own wins, then the lowest. Pixels
  // without a segment stay so. `mixed`: all pixels whose window holds more than one segment, from
  // left to right; others may be among them.
  void filter(PixelImage& image, std::span<const PixelSpan> mixed, std::uint32_t radius,
              float depth_gate_m);

 private:
  // A segment with half of the window's pixels or more needs no rival counted.
  void filter_block(const PixelImage& image, std::size_t begin, std::size_t end,
                    std::uint32_t radius, float depth_gate_m);
  [[nodiscard]] std::uint32_t mode_around(const PixelImage& image, std::size_t middle,
                                          std::uint32_t radius, float depth_gate_m);

  struct Count {
    std::uint32_t segment = 0;
    std::uint32_t pixels = 0;
  };
  struct Change {
    std::size_t pixel = 0;
    std::uint32_t segment = 0;
  };
  std::vector<Count> counts_;
  std::vector<Change> changes_;  // made at the end: windows see what was before
};
static_assert(ModeFilter::max_radius <= ImageLayout::border, "windows reach into the border");

}  // namespace cleave::segmentation
