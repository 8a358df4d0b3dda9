// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/polygon.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cleave::render {
namespace {

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Interval project(const Polygon& polygon, const Eigen::Vector2d& axis) {
  Interval interval;
  for (const Eigen::Vector2d& corner : polygon) {
    const double position = axis.dot(corner);
    interval.low = std::min(interval.low, position);
    interval.high = std::max(interval.high, position);
  }
  return interval;
}

bool separated_by_a_side_of(const Polygon& polygon, const Polygon& other) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Eigen::Vector2d outward(side.y(), -side.x());
    if (project(other, outward).low >= project(polygon, outward).high) return true;
  }
  return false;
}

}  // namespace

Polygon polygon_around_circle(const Eigen::Vector2d& centre, double radius) {
  constexpr int sides = 32;
  constexpr double step_rad = 2 * std::numbers::pi / sides;
  const double corner_radius = radius / std::cos(step_rad / 2);
  Polygon polygon;
  polygon.reserve(sides);
  for (int i = 0; i < sides; ++i) {
    polygon.emplace_back(
        centre + corner_radius * Eigen::Vector2d(std::cos(i * step_rad), std::sin(i * step_rad)));
  }
  return polygon;
}

Polygon turned_rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                         const Eigen::Vector2d& origin, double yaw) {
  const Eigen::Rotation2Dd turn(yaw);
  return {origin + turn * low, origin + turn * Eigen::Vector2d(high.x(), low.y()),
          origin + turn * high, origin + turn * Eigen::Vector2d(low.x(), high.y())};
}

bool overlap(const Polygon& a, const Polygon& b) {
  return !separated_by_a_side_of(a, b) && !separated_by_a_side_of(b, a);
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Eigen::Vector2d to_point = point - polygon[i];
    if (side.x() * to_point.y() - side.y() * to_point.x() < 0) return false;
  }
  return true;
}

}  // namespace cleave::render
