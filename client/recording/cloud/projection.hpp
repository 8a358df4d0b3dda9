// SPDX-License-Identifier: BSD-3-Clause
// From depth in millimetres to points: the ways in which sensors and tools compute it, to the bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::recording {

// Pinhole intrinsics in pixels.
struct Intrinsics {
  float fx = 0;
  float fy = 0;
  float cx = 0;
  float cy = 0;
  bool operator==(const Intrinsics&) const = default;
};

// With z = depth * 0.001. `text`: x, y, z were written with 7 decimal digits, and read back.
// Recorded: the numbers never change meaning.
enum class Projection : std::uint32_t {
  none = 0,
  ray = 1,    // in 32 bits, x = ((u - cx) / fx) * z, as the grabber does
  point = 2,  // in 32 bits, x = ((u - cx) * z) * (1 / fx), as PCL and the tools after it do
  point_text = 3,
  precise = 4,  // x = (u - cx) / fx * z in 64 bits, then rounded to 32
  precise_text = 5
};

struct DepthView {
  std::span<const std::uint16_t> depth_mm;  // row-major; 0 = no measurement
  std::uint32_t width;
  std::uint32_t height;
};

// Writes 3 floats a pixel; NaN NaN NaN = no measurement. Deterministic on every machine with IEEE
// arithmetic. `projection` is not `none`.
void project(const DepthView& image, const Intrinsics& intrinsics, Projection projection,
             float* xyz);

}  // namespace cleave::recording
