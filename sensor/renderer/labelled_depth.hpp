// SPDX-License-Identifier: BSD-3-Clause
// A rendered frame as a camera driver would hand it out, with the truth beside it.
#pragma once

#include <cstdint>
#include <vector>

#include "sensor/renderer/view/camera.hpp"

namespace cleave::render {

// Row-major; 0 = no measurement, label 0. Labels: one a visible connected part of a surface.
// 1 to 9 = the table, 1 the largest part; (k + 2) * 10 + 0 to 9 = object k's outside, 1000 more the
// inner wall of a mug or the hollow of a bowl, 2000 more a mug's floor, 3000 more its handle.
struct LabelledDepth {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint16_t> depth_mm;
  std::vector<std::uint16_t> label;
};

// Points of a depth image: x, y, z in metres, optical frame, row-major, NaN = no measurement.
[[nodiscard]] std::vector<float> to_points(const LabelledDepth& image,
                                           const Intrinsics& intrinsics);

}  // namespace cleave::render
