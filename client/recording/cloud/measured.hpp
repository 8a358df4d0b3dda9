// SPDX-License-Identifier: BSD-3-Clause
// What counts as a measurement, wherever points come from.
#pragma once

#include <cmath>
#include <limits>

namespace cleave::recording {

// What all three coordinates are made where nothing was measured.
inline constexpr float no_measurement = std::numeric_limits<float>::quiet_NaN();

// Three finite coordinates that are not all 0: for "nothing here", some sensors and formats write
// NaN, others the origin, where no sensor sees anything. The segmentation, which stands alone, says
// the same of the points that it is given.
template <class Number>
[[nodiscard]] bool is_measured(const Number* xyz) {
  return std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]) &&
         (xyz[0] != 0 || xyz[1] != 0 || xyz[2] != 0);
}

}  // namespace cleave::recording
