// SPDX-License-Identifier: BSD-3-Clause
// Whether what lies in a column of an image is also seen in one column, and the columns in order.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/view/camera/pixel_sample.hpp"

namespace cleave::segmentation {

// For columns and rows alike. Columns may be anywhere: some may be missing between them.
class StraightLines {
 public:
  void start() {
    for (std::vector<double>& line : seen_) line.clear();
  }
  // A pixel of this sampled line is seen at that column, finite, in pixels.
  void add(std::uint32_t line, double at) { seen_[line].push_back(at); }

  // But for a few strays.
  [[nodiscard]] bool are_straight();

 private:
  std::vector<std::vector<double>> seen_{PixelSample::max_lines};
};

}  // namespace cleave::segmentation
