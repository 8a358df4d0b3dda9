// SPDX-License-Identifier: BSD-3-Clause
// How far apart the pixels of an image look.
#pragma once

#include <vector>

#include "segmentation/cloud_view.hpp"

namespace cleave::segmentation {

class PixelPitchFinder {
 public:
  // Mean step of x/z from one pixel to the next along rows, over every eighth row. Steps that are
  // far from most, where a stray point is, do not count. 0 if no two pixels side by side are
  // measured and in front.
  [[nodiscard]] float find(const CloudView& cloud);

 private:
  std::vector<double> steps_;
};

}  // namespace cleave::segmentation
