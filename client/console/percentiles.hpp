// SPDX-License-Identifier: BSD-3-Clause
// Many measured values in a few: percentiles, mean and extremes.
#pragma once

#include <cstddef>
#include <vector>

namespace cleave {

// By nearest rank: each is a value that was measured. All 0 where nothing was.
struct Percentiles {
  double median = 0;
  double p90 = 0;
  double p99 = 0;
};
[[nodiscard]] Percentiles percentiles(std::vector<double> values);

struct Spread {
  double mean = 0;
  double min = 0;
  double max = 0;
};
// Of values in their order: the same values give the same mean, bit by bit. All 0 where there are
// none.
[[nodiscard]] Spread spread(const std::vector<double>& values);

// The latest `capacity` values: a stream may be watched for days.
class RecentValues {
 public:
  explicit RecentValues(std::size_t capacity = 65536) : capacity_(capacity) {}
  void add(double value);
  [[nodiscard]] Percentiles percentiles() const { return cleave::percentiles(values_); }

 private:
  std::size_t capacity_;
  std::size_t next_ = 0;  // the oldest value, once values_ is full
  std::vector<double> values_;
};

}  // namespace cleave
