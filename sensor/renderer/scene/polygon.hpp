// SPDX-License-Identifier: BSD-3-Clause
// Convex polygons on the table: what the placement of objects needs.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cleave::render {

// Convex, counter-clockwise, at least three corners.
using Polygon = std::vector<Eigen::Vector2d>;

// A regular polygon with 32 sides that contains the circle (0.5 % larger at its corners).
[[nodiscard]] Polygon polygon_around_circle(const Eigen::Vector2d& centre, double radius);

// The rectangle [low, high] of a local frame, turned by `yaw` and moved to `origin`.
[[nodiscard]] Polygon turned_rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                                       const Eigen::Vector2d& origin, double yaw);

// Whether the interiors meet: separating axes, exact for convex polygons.
[[nodiscard]] bool overlap(const Polygon& a, const Polygon& b);

[[nodiscard]] bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

}  // namespace cleave::render
