// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/object.hpp"

#include <cmath>
#include <numbers>

namespace cleave::render {
namespace {

constexpr double handle_reach_m = 0.032;  // of the bar's axis, from the wall
// Where the axis starts: the round ends meet the wall and do not come out in the hollow.
constexpr double handle_start_m = handle_bar_radius_m - 0.004;

struct Extent {
  double radius_m;  // largest horizontal distance from the origin
  double height_m;
  bool flat_top;
};

struct ExtentOf {
  Extent operator()(const Box& s) const {
    return {std::hypot(s.half_m.x(), s.half_m.y()), 2 * s.half_m.z(), true};
  }
  Extent operator()(const Cylinder& s) const { return {s.radius_m, s.height_m, true}; }
  Extent operator()(const LyingCylinder& s) const {
    return {std::hypot(s.half_length_m, s.radius_m), 2 * s.radius_m, false};
  }
  Extent operator()(const Sphere& s) const { return {s.radius_m, 2 * s.radius_m, false}; }
  Extent operator()(const Bowl& s) const { return {s.radius_m, s.height_m, false}; }
  Extent operator()(const Mug& s) const {
    const double handle_m = s.handle ? handle_reach_m + handle_bar_radius_m : 0;
    return {s.radius_m + handle_m, s.height_m, false};
  }
};

struct FootprintOf {
  Eigen::Vector2d origin;
  double yaw;

  std::vector<Polygon> rectangle(double half_x, double half_y) const {
    const Eigen::Vector2d half(half_x, half_y);
    return {turned_rectangle(-half, half, origin, yaw)};
  }
  std::vector<Polygon> circle(double radius) const {
    return {polygon_around_circle(origin, radius)};
  }

  std::vector<Polygon> operator()(const Box& s) const {
    return rectangle(s.half_m.x(), s.half_m.y());
  }
  std::vector<Polygon> operator()(const Cylinder& s) const { return circle(s.radius_m); }
  std::vector<Polygon> operator()(const LyingCylinder& s) const {
    return rectangle(s.half_length_m, s.radius_m);
  }
  std::vector<Polygon> operator()(const Sphere& s) const { return circle(s.radius_m); }
  std::vector<Polygon> operator()(const Bowl& s) const { return circle(s.radius_m); }
  std::vector<Polygon> operator()(const Mug& s) const {
    std::vector<Polygon> polygons = circle(s.radius_m);
    if (s.handle) {
      polygons.push_back(turned_rectangle(
          {0, -handle_bar_radius_m},
          {s.radius_m + handle_reach_m + handle_bar_radius_m, handle_bar_radius_m}, origin, yaw));
    }
    return polygons;
  }
};

}  // namespace

std::array<Eigen::Vector3d, handle_points> handle_polyline(const Mug& mug) {
  static const auto half_circle = [] {
    std::array<Eigen::Vector2d, handle_points> points;
    for (std::size_t i = 0; i < handle_points; ++i) {
      const double angle = std::numbers::pi * (0.5 - static_cast<double>(i) / (handle_points - 1));
      points[i] = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    return points;
  }();
  const double half_height = 0.3 * mug.height_m;
  std::array<Eigen::Vector3d, handle_points> points;
  for (std::size_t i = 0; i < handle_points; ++i) {
    const double from_wall = std::lerp(handle_start_m, handle_reach_m, half_circle[i].x());
    points[i] = Eigen::Vector3d(mug.radius_m + from_wall, 0,
                                mug.height_m / 2 + half_circle[i].y() * half_height);
  }
  return points;
}

double height_m(const Shape& shape) {
  return std::visit(ExtentOf{}, shape).height_m;
}

bool has_flat_top(const Shape& shape) {
  return std::visit(ExtentOf{}, shape).flat_top;
}

std::vector<Polygon> footprint(const Object& object) {
  return std::visit(FootprintOf{object.base_m.head<2>(), object.yaw_rad}, object.shape);
}

BoundingSphere bounding_sphere(const Object& object) {
  const Extent extent = std::visit(ExtentOf{}, object.shape);
  const Eigen::Vector3d centre = object.base_m + Eigen::Vector3d(0, 0, extent.height_m / 2);
  // A sphere's own radius is smaller than that of its bounding cylinder.
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) return {centre, sphere->radius_m};
  return {centre, std::hypot(extent.radius_m, extent.height_m / 2)};
}

}  // namespace cleave::render
