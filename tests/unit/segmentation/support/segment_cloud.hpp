// SPDX-License-Identifier: BSD-3-Clause
// All that a segmenter says of a cloud.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/segmenter.hpp"

namespace cleave::segmentation {

struct Segmented {
  Outcome outcome = Outcome::bad_size;
  std::vector<std::uint16_t> labels;
  Segmentation segmentation;
};

// Labels are something else before: every one has to be written.
[[nodiscard]] inline Segmented segment(Segmenter& segmenter, const CloudView& cloud) {
  Segmented result;
  result.labels.assign(cloud.size(), 77);
  result.outcome = segmenter.segment(cloud, result.labels, result.segmentation);
  return result;
}

}  // namespace cleave::segmentation
