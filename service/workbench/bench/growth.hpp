// SPDX-License-Identifier: BSD-3-Clause
// How the cost grows with the number of points.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "workbench/bench/bench.hpp"

namespace cleave::workbench {

// The slope of the line through (ln x, ln y), by least squares: p of y ~ x^p. Two different x at
// least, all values positive; 0 otherwise.
[[nodiscard]] double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

// The same clouds with a quarter of their points, all, and four times as many.
class Growth {
 public:
  explicit Growth(const BenchPlan& plan) : quarter_(plan), whole_(plan), fourfold_(plan) {}

  void measure(const std::string& name, const evaluation::LabelledCloud& cloud);

  // {"points": [..], "milliseconds": [..], "exponent": .., "n_log_n_exponent": .., "stages":
  // {"voxelise": {"milliseconds": [..], "exponent": ..}, ..}}: medians by size, smallest first.
  // `n_log_n_exponent` is what the same fit makes of n log n.
  [[nodiscard]] Json json() const;
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::array<const BenchResult*, 3> results() const;
  [[nodiscard]] std::vector<double> points() const;
  [[nodiscard]] std::vector<double> n_log_n() const;
  [[nodiscard]] std::vector<double> total_ms() const;
  [[nodiscard]] std::vector<double> stage_ms(segmentation::Stage stage) const;

  Bench quarter_, whole_, fourfold_;
};

}  // namespace cleave::workbench
