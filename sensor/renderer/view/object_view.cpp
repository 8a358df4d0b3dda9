// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/object_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleave::render {
namespace {

struct Slopes {
  double low, high;
};

// The slopes of the two lines through the origin that touch a circle at (sideways, depth).
Slopes tangents(double sideways, double depth, double radius) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double denominator = depth * depth - radius * radius;
  if (depth <= radius) return {-infinity, infinity};
  const double root = radius * std::sqrt(sideways * sideways + denominator);
  return {(sideways * depth - root) / denominator, (sideways * depth + root) / denominator};
}

Eigen::Isometry3d table_from_object(const Object& object) {
  return Eigen::Translation3d(object.base_m) *
         Eigen::AngleAxisd(object.yaw_rad, Eigen::Vector3d::UnitZ());
}

std::uint32_t clipped(double pixel, std::uint32_t size) {
  return static_cast<std::uint32_t>(std::clamp(pixel, 0.0, static_cast<double>(size)));
}

}  // namespace

ObjectView::ObjectView(const Object& object, const Eigen::Isometry3d& table_from_camera,
                       const Intrinsics& intrinsics)
    : object_from_camera(table_from_object(object).inverse() * table_from_camera) {
  const BoundingSphere sphere = bounding_sphere(object);
  const Eigen::Vector3d centre = table_from_camera.inverse() * sphere.centre_m;
  const Slopes x = tangents(centre.x(), centre.z(), sphere.radius_m);
  const Slopes y = tangents(centre.y(), centre.z(), sphere.radius_m);
  bounds = {intrinsics.cx + intrinsics.fx * x.low, intrinsics.cx + intrinsics.fx * x.high,
            intrinsics.cy + intrinsics.fy * y.low, intrinsics.cy + intrinsics.fy * y.high};
  nearest_depth_m = std::max(0.0, centre.z() - sphere.radius_m);
}

PixelRectangle pixels_within(const PixelBounds& bounds, const CameraModel& camera) {
  return {clipped(std::ceil(bounds.x_low), camera.width),
          clipped(std::floor(bounds.x_high) + 1, camera.width),
          clipped(std::ceil(bounds.y_low), camera.height),
          clipped(std::floor(bounds.y_high) + 1, camera.height)};
}

}  // namespace cleave::render
