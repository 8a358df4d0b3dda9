// SPDX-License-Identifier: BSD-3-Clause
// What counts as a measurement.
#pragma once

#include <cstddef>

namespace cleave::segmentation {

// Three finite coordinates that are not all 0: for "nothing here", some sensors and formats write
// NaN, others the origin, where no sensor sees anything. Without a branch, so that loops over it
// are vectorised; x * 0 is 0 for finite numbers only.
[[nodiscard]] inline __attribute__((always_inline)) bool is_measured(float x, float y, float z) {
  return (x * 0 + y * 0 + z * 0 == 0) & ((x != 0) | (y != 0) | (z != 0));
}

[[nodiscard]] inline bool is_measured(const float* xyz) {
  return is_measured(xyz[0], xyz[1], xyz[2]);
}

// Of so many points, how many may lie where the sensor does not look: what is on or behind its
// plane is then no measurement either, instead of a sign that the cloud was not seen from there.
[[nodiscard]] inline std::size_t max_strays(std::size_t points) {
  constexpr std::size_t points_a_stray = 1000;
  constexpr std::size_t one_in = 100;
  return points < one_in ? 0 : points < points_a_stray ? 1 : points / points_a_stray;
}

}  // namespace cleave::segmentation
