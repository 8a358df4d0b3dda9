// SPDX-License-Identifier: BSD-3-Clause
// Small patches of all segments, which stand for their points.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/surfel.hpp"

namespace cleave::segmentation {

// Structure of arrays: of a patch.
struct Surface {
  std::vector<Surfel> surfel;
  std::vector<std::uint32_t> segment;
  std::vector<float> points;  // how many it stands for

  void clear() {
    surfel.clear();
    segment.clear();
    points.clear();
  }
  void add(const Surfel& patch, std::uint32_t of_segment, float of_points) {
    surfel.push_back(patch);
    segment.push_back(of_segment);
    points.push_back(of_points);
  }
};

}  // namespace cleave::segmentation
