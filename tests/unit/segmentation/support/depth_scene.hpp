// SPDX-License-Identifier: BSD-3-Clause
// A small depth image of two boxes on a table, for tests of what works on cells.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "segmentation/cloud_view.hpp"

namespace cleave::segmentation {

struct DepthScene {
  std::uint32_t width = 160, height = 120;
  std::vector<float> xyz;

  [[nodiscard]] CloudView view() const { return {xyz.data(), 3, width, height}; }

  // Noise of a structured-light camera in 1/z; some pixels are not measured.
  explicit DepthScene(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    // Nearly normal, and the same on every machine: no logarithm.
    const auto noise = [&] {
      float sum = -6;
      for (int i = 0; i < 12; ++i) sum += uniform(random);
      return 0.0027F * sum;
    };
    for (std::uint32_t row = 0; row < height; ++row) {
      for (std::uint32_t column = 0; column < width; ++column) {
        const float u = (static_cast<float>(column) - 79.5F) / 525;
        const float v = (static_cast<float>(row) - 59.5F) / 525;
        const float q = inverse_depth(u, v, column, row) + noise();
        const bool measured = uniform(random) > 0.02F;
        const float z = measured ? 1 / q : std::numeric_limits<float>::quiet_NaN();
        xyz.insert(xyz.end(), {u * z, v * z, z});
      }
    }
  }

 private:
  static float inverse_depth(float u, float v, std::uint32_t column, std::uint32_t row) {
    const bool box = column > 40 && column < 90 && row > 30 && row < 80;
    const bool front = box && row > 55;
    if (front) return 1.35F - 1.2F * v + 0.4F * u;
    if (box) return 1.35F + 2.0F * v + 0.4F * u;
    return 1.0F + 1.5F * v;
  }
};

}  // namespace cleave::segmentation
