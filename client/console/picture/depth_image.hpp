// SPDX-License-Identifier: BSD-3-Clause
// A labelled cloud as an image: one depth and one label a pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cleave {

// Points x, y, z in metres, row-major, the first three of every `stride` floats.
struct PointsView {
  const float* xyz = nullptr;
  std::size_t stride = 3;
  std::uint32_t width = 0;
  std::uint32_t height = 0;  // 1 = unorganised

  [[nodiscard]] std::size_t size() const { return std::size_t{width} * height; }
  [[nodiscard]] bool organised() const { return height > 1; }
  [[nodiscard]] const float* point(std::size_t i) const { return xyz + i * stride; }
};

struct DepthImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> depth_m;        // NaN = no measurement
  std::vector<std::uint16_t> label;  // 0 = no segment
};

struct ImageSize {
  std::uint32_t width = 640;
  std::uint32_t height = 480;
};

// An organised cloud pixel by pixel. An unorganised one is projected onto an image of `projected`
// by a pinhole fitted to its extent: the nearest point wins, and sparse clouds get a few pixels a
// point. `labels` has one value a point. Deterministic.
[[nodiscard]] DepthImage depth_image(const PointsView& cloud, std::span<const std::uint16_t> labels,
                                     ImageSize projected = {});

// Half as many pixels as points, so that hardly one between two neighbours stays empty.
[[nodiscard]] ImageSize filled_size(std::size_t points);

}  // namespace cleave
