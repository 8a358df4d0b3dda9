// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/camera/camera.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::segmentation {

bool has_sound_pixels(const Camera& camera, bool square) {
  constexpr double right_angle = 0.03;  // cosine
  constexpr double max_ratio = 8;
  constexpr double tolerance = 0.03;
  const double a = camera.right().norm();
  const double b = camera.down().norm();
  const double cosine = camera.right().dot(camera.down()) / (a * b);
  const double ratio = std::max(a, b) / std::min(a, b);
  if (!(std::abs(cosine) < right_angle && ratio < max_ratio)) return false;
  return !square || std::abs(ratio / std::round(ratio) - 1) < tolerance;
}

}  // namespace cleave::segmentation
