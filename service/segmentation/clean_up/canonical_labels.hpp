// SPDX-License-Identifier: BSD-3-Clause
// Labels that depend on the segments alone, not on how they were found.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "segmentation/points/point_runs.hpp"

namespace cleave::segmentation {

inline constexpr std::size_t max_labels = std::numeric_limits<std::uint16_t>::max();

class LabelOrder {
 public:
  // `settled`: of a segment, the one that its points belong to, or no_index. Label of every
  // segment: 1 for the most points, ties by the lowest point, 0 for no point and for those that
  // belong to none. False, without any label, if there are more than max_labels.
  [[nodiscard]] bool order(std::span<const PointRun> runs,
                           const std::vector<std::uint32_t>& settled,
                           std::vector<std::uint16_t>& label_of_segment);

 private:
  struct Entry {
    std::uint32_t points = 0;
    std::uint32_t first_run = 0;
    std::uint32_t segment = 0;
  };
  std::vector<Entry> entries_;
};

}  // namespace cleave::segmentation
