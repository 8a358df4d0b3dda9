// SPDX-License-Identifier: BSD-3-Clause
// Puts objects on the table: free, touching another, or on top of one.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sensor/renderer/scene/object.hpp"
#include "sensor/renderer/scene/random.hpp"

namespace cleave::render {

// Where free objects' centres lie; the others' may lie a little outside.
struct PlacementArea {
  Eigen::Vector2d centre_m;
  Eigen::Vector2d half_m;
};

struct PlacementChances {
  double touching;
  double stacked;
};

// Exactly `count` objects, none within another. When the table is full, new ones get smaller.
[[nodiscard]] std::vector<Object> place_objects(std::uint32_t count, double scale,
                                                const PlacementArea& area,
                                                const PlacementChances& chances, Random& random);

}  // namespace cleave::render
