// SPDX-License-Identifier: BSD-3-Clause
// How many points each true segment shares with each found one: what every measure starts from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::evaluation {

// Rows: true segments; columns: found segments that have a point with a true label; both in the
// order of their labels. Counts of points; whole numbers.
struct Overlaps {
  std::vector<std::vector<double>> common;
  std::vector<double> truth_size, found_size;
  std::vector<std::uint32_t> truth_label;
  std::vector<std::uint16_t> found_label;
  double points = 0;  // that have a true label

  [[nodiscard]] std::size_t true_segments() const { return truth_size.size(); }
  [[nodiscard]] std::size_t found_segments() const { return found_size.size(); }
  // Intersection over union, equation 5.1.
  [[nodiscard]] double iou(std::size_t row, std::size_t column) const {
    const double both = common[row][column];
    return both / (truth_size[row] + found_size[column] - both);
  }
};

// One true and one found label a point; label 0 is none. Points without a true label do not count.
[[nodiscard]] Overlaps count_overlaps(std::span<const std::uint32_t> truth,
                                      std::span<const std::uint16_t> found);

}  // namespace cleave::evaluation
