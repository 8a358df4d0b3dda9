// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/assignment.hpp"

#include <limits>

namespace cleave::evaluation {

std::vector<std::size_t> best_assignment(const std::vector<std::vector<double>>& gain) {
  // Shortest augmenting paths on costs = -gain; index 0 of rows and columns stands for "free".
  const std::size_t rows = gain.size();
  const std::size_t columns = rows == 0 ? 0 : gain.front().size();
  std::vector<double> row_price(rows + 1, 0), column_price(columns + 1, 0);
  std::vector<std::size_t> row_of(columns + 1, 0), previous(columns + 1, 0);
  for (std::size_t row = 1; row <= rows; ++row) {
    std::vector<double> slack(columns + 1, std::numeric_limits<double>::infinity());
    std::vector<bool> visited(columns + 1, false);
    std::size_t column = 0;
    row_of[0] = row;
    while (row_of[column] != 0) {
      visited[column] = true;
      std::size_t next = 0;
      double step = std::numeric_limits<double>::infinity();
      for (std::size_t c = 1; c <= columns; ++c) {
        if (visited[c]) continue;
        const double reduced =
            -gain[row_of[column] - 1][c - 1] - row_price[row_of[column]] - column_price[c];
        if (reduced < slack[c]) {
          slack[c] = reduced;
          previous[c] = column;
        }
        if (slack[c] < step) {
          step = slack[c];
          next = c;
        }
      }
      for (std::size_t c = 0; c <= columns; ++c) {
        if (visited[c]) {
          row_price[row_of[c]] += step;
          column_price[c] -= step;
        } else {
          slack[c] -= step;
        }
      }
      column = next;
    }
    for (; column != 0; column = previous[column]) row_of[column] = row_of[previous[column]];
  }
  std::vector<std::size_t> result(rows, 0);
  for (std::size_t c = 1; c <= columns; ++c) {
    if (row_of[c] != 0) result[row_of[c] - 1] = c - 1;
  }
  return result;
}

}  // namespace cleave::evaluation
