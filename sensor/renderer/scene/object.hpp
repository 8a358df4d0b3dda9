// SPDX-License-Identifier: BSD-3-Clause
// The things that stand on the table, and the space they take.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <variant>
#include <vector>

#include "sensor/renderer/scene/polygon.hpp"

namespace cleave::render {

// Shapes in their own frame: it stands on the plane z = 0, its axis (but a lying cylinder's, which
// is x) is z. Metres.
struct Box {
  Eigen::Vector3d half_m;
};
struct Cylinder {
  double radius_m;
  double height_m;
};
struct LyingCylinder {
  double radius_m;
  double half_length_m;
};
struct Sphere {
  double radius_m;
};
// A sphere's lower part with a flat foot and a hollow of even thickness.
struct Bowl {
  double radius_m;         // of the outer sphere
  double centre_height_m;  // of the sphere's centre; less than the radius, not less than the height
  double height_m;         // of the rim
  double wall_m;
};
struct Mug {
  double radius_m;
  double height_m;
  double wall_m;
  bool handle;  // on the side of +x
};
using Shape = std::variant<Box, Cylinder, LyingCylinder, Sphere, Bowl, Mug>;

// A mug's handle: round bars along half an ellipse.
inline constexpr double handle_bar_radius_m = 0.006;
inline constexpr std::size_t handle_points = 7;
[[nodiscard]] std::array<Eigen::Vector3d, handle_points> handle_polyline(const Mug& mug);

struct Object {
  Shape shape;
  Eigen::Vector3d base_m = Eigen::Vector3d::Zero();  // the shape's origin in the table frame
  double yaw_rad = 0;
};

struct BoundingSphere {
  Eigen::Vector3d centre_m;  // table frame
  double radius_m;
};

[[nodiscard]] double height_m(const Shape& shape);
// Whether other objects can stand on it.
[[nodiscard]] bool has_flat_top(const Shape& shape);
// What it covers of the table, seen from above: the union of convex polygons that contain it.
[[nodiscard]] std::vector<Polygon> footprint(const Object& object);
[[nodiscard]] BoundingSphere bounding_sphere(const Object& object);

}  // namespace cleave::render
