// SPDX-License-Identifier: BSD-3-Clause
// Which row belongs to which column, when each may be taken once.
#pragma once

#include <cstddef>
#include <vector>

namespace cleave::evaluation {

// The assignment of rows to different columns with the largest sum; `gain` has at most as many rows
// as columns, all of one length. Returns the column of every row (Kuhn-Munkres, O(n^3)).
[[nodiscard]] std::vector<std::size_t> best_assignment(
    const std::vector<std::vector<double>>& gain);

}  // namespace cleave::evaluation
