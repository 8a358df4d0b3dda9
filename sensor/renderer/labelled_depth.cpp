// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/labelled_depth.hpp"

#include <cstddef>
#include <limits>

namespace cleave::render {

std::vector<float> to_points(const LabelledDepth& image, const Intrinsics& intrinsics) {
  constexpr double metres_per_mm = 0.001;
  std::vector<float> points(image.depth_mm.size() * 3, std::numeric_limits<float>::quiet_NaN());
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x, ++i) {
      if (image.depth_mm[i] == 0) continue;
      const double z_m = image.depth_mm[i] * metres_per_mm;
      points[3 * i] = static_cast<float>((x - intrinsics.cx) / intrinsics.fx * z_m);
      points[3 * i + 1] = static_cast<float>((y - intrinsics.cy) / intrinsics.fy * z_m);
      points[3 * i + 2] = static_cast<float>(z_m);
    }
  }
  return points;
}

}  // namespace cleave::render
