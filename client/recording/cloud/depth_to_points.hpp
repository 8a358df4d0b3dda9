// SPDX-License-Identifier: BSD-3-Clause
// Depth becomes points as the grabber publishes them, and as whoever reads its input later must.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "recording/cloud/projection.hpp"

namespace cleave::recording {

// A depth image where a sensor left it.
struct DepthRows {
  const std::uint16_t* depth;  // 0 = no measurement
  std::uint32_t width;
  std::uint32_t height;
  std::size_t stride_bytes;  // from one row to the next, a multiple of 2
  float unit_m;              // of a depth of 1: 0.001 or 0.0001
};

// The rays of a pinhole camera, computed once for a size and intrinsics (Projection::ray):
//   z = depth * unit, x = (u - cx) / fx * z, y = (v - cy) / fy * z.
class DepthProjection {
 public:
  DepthProjection() = default;
  DepthProjection(std::uint32_t width, std::uint32_t height, const Intrinsics& intrinsics);

  // Writes width * height points; the image must have the size of the construction. Deterministic.
  void write_points(const DepthRows& image, float* xyz) const;
  // The same with a depth in metres a pixel, row-major; NaN = no measurement.
  void write_points(std::span<const float> depth_m, float* xyz) const;

 private:
  std::vector<float> column_;  // x / z of a column
  std::vector<float> row_;     // y / z of a row
};

// Intrinsics of a camera with these fields of view: f = size / (2 tan(fov / 2)), and the principal
// point in the middle of the pixel grid, (size - 1) / 2. All 0 unless both angles are within
// (0, pi).
[[nodiscard]] Intrinsics intrinsics_from_fov(std::uint32_t width, std::uint32_t height,
                                             float horizontal_rad, float vertical_rad);

}  // namespace cleave::recording
