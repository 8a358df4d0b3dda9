// SPDX-License-Identifier: BSD-3-Clause
#include "console/percentiles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cleave {

Percentiles percentiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const auto rank =
        static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[rank - 1];
  };
  return {at(0.5), at(0.9), at(0.99)};
}

Spread spread(const std::vector<double>& values) {
  if (values.empty()) return {};
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  return {sum / static_cast<double>(values.size()), *min, *max};
}

void RecentValues::add(double value) {
  if (values_.size() < capacity_) {
    values_.push_back(value);
    return;
  }
  values_[next_] = value;
  next_ = (next_ + 1) % capacity_;
}

}  // namespace cleave
