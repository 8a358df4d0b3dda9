// SPDX-License-Identifier: BSD-3-Clause
// Where points lie, and how large what they make is, whatever strays there are.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cleave::segmentation {

// Coordinates beyond count as this: no product of them overflows.
inline constexpr double farthest_m = 1e9;

// Where half of the values are less; reorders them. Not empty.
[[nodiscard]] double median_of(std::vector<double>& values);

struct Middle {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // of each coordinate the median
  double extent_m = 0;                              // median distance from there
};

class MiddleFinder {
 public:
  // Of no points, the origin.
  [[nodiscard]] Middle find(const std::vector<Eigen::Vector3d>& points);

 private:
  std::vector<double> values_;
};

}  // namespace cleave::segmentation
