#include "tests/support/covering.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace cleave::tests {
namespace {

// Rows: true segments; columns: found segments; both in the order of their labels.
struct Overlaps {
  std::vector<std::vector<double>> common;  // points
  std::vector<double> truth_size, found_size;
  double points = 0;
};

template <typename Label>
std::map<Label, std::size_t> number_labels(std::span<const Label> labels) {
  std::map<Label, std::size_t> number;
  for (const Label label : labels) {
    if (label != 0) number.emplace(label, 0);
  }
  std::size_t next = 0;
  for (auto& [label, index] : number) index = next++;
  return number;
}

Overlaps count_overlaps(std::span<const std::uint32_t> truth,
                        std::span<const std::uint16_t> found) {
  std::vector<std::uint16_t> counted(found.begin(), found.end());
  for (std::size_t i = 0; i < counted.size(); ++i) {
    if (truth[i] == 0) counted[i] = 0;
  }
  const auto rows = number_labels(truth);
  const auto columns = number_labels<std::uint16_t>(counted);
  Overlaps o;
  o.common.assign(rows.size(), std::vector<double>(columns.size(), 0));
  o.truth_size.assign(rows.size(), 0);
  o.found_size.assign(columns.size(), 0);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) continue;
    const std::size_t row = rows.at(truth[i]);
    o.points += 1;
    o.truth_size[row] += 1;
    if (counted[i] == 0) continue;
    const std::size_t column = columns.at(counted[i]);
    o.found_size[column] += 1;
    o.common[row][column] += 1;
  }
  return o;
}

std::vector<std::vector<double>> transposed(const std::vector<std::vector<double>>& matrix) {
  std::vector<std::vector<double>> result(matrix.front().size());
  for (const auto& row : matrix) {
    for (std::size_t c = 0; c < row.size(); ++c) result[c].push_back(row[c]);
  }
  return result;
}

std::uint32_t count_matches(const std::vector<std::vector<double>>& common) {
  if (common.empty() || common.front().empty()) return 0;
  const auto gain = common.size() <= common.front().size() ? common : transposed(common);
  const auto column = best_assignment(gain);
  std::uint32_t matches = 0;
  for (std::size_t row = 0; row < gain.size(); ++row) matches += gain[row][column[row]] > 0 ? 1 : 0;
  return matches;
}

}  // namespace

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

Quality judge(std::span<const std::uint32_t> truth, std::span<const std::uint16_t> found) {
  const Overlaps o = count_overlaps(truth, found);
  Quality quality;
  if (o.points == 0) return quality;
  for (std::size_t row = 0; row < o.common.size(); ++row) {
    double best = 0;  // equation 5.1
    for (std::size_t column = 0; column < o.found_size.size(); ++column) {
      const double common = o.common[row][column];
      best = std::max(best, common / (o.truth_size[row] + o.found_size[column] - common));
    }
    quality.weighted_covering += best * o.truth_size[row] / o.points;
    quality.unweighted_covering += best / static_cast<double>(o.truth_size.size());
  }
  const std::uint32_t matches = count_matches(o.common);
  quality.under = static_cast<std::uint32_t>(o.truth_size.size()) - matches;
  quality.over = static_cast<std::uint32_t>(o.found_size.size()) - matches;
  return quality;
}

}  // namespace cleave::tests
