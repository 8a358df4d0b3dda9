#include "cleave/console/percentiles.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::client {

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

void RecentValues::add(double value) {
  if (values_.size() < capacity_) {
    values_.push_back(value);
    return;
  }
  values_[next_] = value;
  next_ = (next_ + 1) % capacity_;
}

}  // namespace cleave::client
