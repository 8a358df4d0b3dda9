// SPDX-License-Identifier: BSD-3-Clause
// What most values are like, whatever a few stray ones are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cleave::recording {

// The value, of one or more, below or at which `share` (0 to 1) of them are; reorders them.
template <class Number>
[[nodiscard]] Number percentile(std::vector<Number>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace cleave::recording
