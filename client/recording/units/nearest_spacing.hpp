// SPDX-License-Identifier: BSD-3-Clause
// How far apart points of a plane are, and how alike those distances.
#pragma once

#include <cstddef>
#include <vector>

namespace cleave::recording {

struct PlanePoint {
  float x = 0, y = 0;
};

struct NearestSpacing {
  double median = 0;  // distance of a point's nearest neighbour; 0 = none was found
  double spread = 0;  // of these distances, the 90th percentile by the 10th; 1 in a grid
};

// Of about a thousand points, evenly picked; equal points do not count as neighbours, and points in
// a crowd, thousands of times as dense as most, not at all. Linear time.
[[nodiscard]] NearestSpacing nearest_spacing(const std::vector<PlanePoint>& points);

}  // namespace cleave::recording
