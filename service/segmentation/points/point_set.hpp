// SPDX-License-Identifier: BSD-3-Clause
// The points that were measured, out of a cloud where some were not.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/cloud_view.hpp"

namespace cleave::segmentation {

// Farther from the sensor, along any axis, than anything it can see. Coordinates beyond count as
// this, so that no later sum or product of them overflows.
inline constexpr float max_coordinate_m = 1e6F;

// Structure of arrays, in the cloud's order.
struct PointSet {
  std::vector<float> x, y, z;        // metres, within +-max_coordinate_m
  std::vector<std::uint32_t> index;  // of the point in the cloud
  std::size_t behind = 0;            // how many have z <= 0

  [[nodiscard]] std::size_t size() const { return index.size(); }
};

// Takes the points that were measured.
void gather_measured_points(const CloudView& cloud, PointSet& points);

// Leaves out those with z <= 0.
void drop_points_behind(PointSet& points);

}  // namespace cleave::segmentation
