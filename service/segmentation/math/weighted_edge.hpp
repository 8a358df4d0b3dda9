// SPDX-License-Identifier: BSD-3-Clause
// An undirected edge, as the eigenproblem sees it.
#pragma once

#include <cstdint>

namespace cleave::segmentation {

struct WeightedEdge {
  std::uint32_t first = 0, second = 0;
  double weight = 0;
};

}  // namespace cleave::segmentation
