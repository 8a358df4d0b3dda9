// SPDX-License-Identifier: BSD-3-Clause
// Points that fill a small volume, for tests against brute force.
#pragma once

#include <cstdint>
#include <random>

#include "segmentation/points/point_set.hpp"

namespace cleave::segmentation {

inline PointSet random_points(std::uint32_t count, float extent_m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, extent_m);
  PointSet points;
  for (std::uint32_t i = 0; i < count; ++i) {
    points.x.push_back(uniform(random) - extent_m / 2);
    points.y.push_back(uniform(random) - extent_m / 2);
    points.z.push_back(uniform(random) + 0.5F);
    points.index.push_back(i);
  }
  return points;
}

}  // namespace cleave::segmentation
