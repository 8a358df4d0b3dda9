// SPDX-License-Identifier: BSD-3-Clause
// Unordered points of a table with three boxes, as a filter of voxels leaves them, in the frame of
// a robot's head: x forward, z up, all of it below.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "segmentation/cloud_view.hpp"

namespace cleave::segmentation {

struct TableCloud {
  std::vector<float> xyz;

  [[nodiscard]] CloudView view() const {
    return {xyz.data(), 3, static_cast<std::uint32_t>(xyz.size() / 3), 1};
  }

  // A point in every square of `spacing`, anywhere in its middle half, lifted by up to a tenth; the
  // whole, a table of 80 by 120 squares, is `spacing` times as large.
  explicit TableCloud(float spacing, unsigned seed = 1) : spacing_(spacing), random_(seed) {
    add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 80, 120);
    for (const auto& [x, y] : {std::array{15, 20}, std::array{40, 60}, std::array{20, 90}}) {
      const auto at = [](int value) { return static_cast<float>(value); };
      add_rectangle({at(x), at(y), 14}, {1, 0, 0}, {0, 1, 0}, 18, 18);
      add_rectangle({at(x), at(y), 1}, {0, 1, 0}, {0, 0, 1}, 18, 13);
      add_rectangle({at(x), at(y), 1}, {1, 0, 0}, {0, 0, 1}, 18, 13);
    }
  }

 private:
  using Vector = std::array<float, 3>;
  void add_rectangle(Vector corner, Vector along, Vector across, int length, int width) {
    constexpr Vector corner_of_table = {60, 10, -60};  // below a sensor in the origin
    std::uniform_real_distribution<float> jitter(0.25F, 0.75F);
    std::uniform_real_distribution<float> lift(-0.05F, 0.05F);
    for (int i = 0; i < length; ++i) {
      for (int j = 0; j < width; ++j) {
        const float a = static_cast<float>(i) + jitter(random_);
        const float b = static_cast<float>(j) + jitter(random_);
        for (std::size_t k = 0; k < 3; ++k) {
          const float off_plane = along[k] + across[k] == 0 ? lift(random_) : 0;
          xyz.push_back(spacing_ * (corner_of_table[k] + corner[k] + a * along[k] + b * across[k] +
                                    off_plane));
        }
      }
    }
  }

  float spacing_;
  std::mt19937 random_;
};

}  // namespace cleave::segmentation
