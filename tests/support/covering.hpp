// How well a segmentation covers the truth (section 5.2 of the thesis).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::tests {

struct Quality {
  double weighted_covering = 0;    // equation 5.2
  double unweighted_covering = 0;  // equation 5.3
  std::uint32_t under = 0;         // true segments without a match, section 5.2.2
  std::uint32_t over = 0;          // found segments without a match
};

// One true and one found label a point; points whose true label is 0 do not count. A found label 0
// is no segment. All 0 where no point counts.
[[nodiscard]] Quality judge(std::span<const std::uint32_t> truth,
                            std::span<const std::uint16_t> found);

// The assignment of rows to different columns with the largest sum; `gain` has at most as many rows
// as columns, all of one length. Returns the column of every row (Kuhn-Munkres, O(n^3)).
[[nodiscard]] std::vector<std::size_t> best_assignment(
    const std::vector<std::vector<double>>& gain);

}  // namespace cleave::tests
