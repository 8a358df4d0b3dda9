// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/middle.hpp"

#include <algorithm>

namespace cleave::segmentation {

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Middle MiddleFinder::find(const std::vector<Eigen::Vector3d>& points) {
  Middle middle;
  if (points.empty()) return middle;
  values_.resize(points.size());
  const auto median = [&](auto&& value_of) {
    std::transform(points.begin(), points.end(), values_.begin(), value_of);
    return median_of(values_);
  };
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    middle.place[axis] = median([axis](const Eigen::Vector3d& p) { return p[axis]; });
  }
  middle.extent_m = median([&](const Eigen::Vector3d& p) { return (p - middle.place).norm(); });
  return middle;
}

}  // namespace cleave::segmentation
