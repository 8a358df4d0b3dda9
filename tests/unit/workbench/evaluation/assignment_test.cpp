// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace cleave::evaluation {
namespace {

TEST(BestAssignment, IsTheBestOfAllPermutations) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::vector<double>> gain(4, std::vector<double>(5));
    for (auto& row : gain) {
      for (double& value : row) value = static_cast<double>(random() % 20);
    }
    const auto sum = [&](const std::vector<std::size_t>& column) {
      double total = 0;
      for (std::size_t row = 0; row < gain.size(); ++row) total += gain[row][column[row]];
      return total;
    };
    std::vector<std::size_t> columns(5);
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    double best = 0;
    do best = std::max(best, sum(columns));
    while (std::next_permutation(columns.begin(), columns.end()));

    EXPECT_DOUBLE_EQ(sum(best_assignment(gain)), best);
  }
}

}  // namespace
}  // namespace cleave::evaluation
