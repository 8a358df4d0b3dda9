// SPDX-License-Identifier: BSD-3-Clause
// An object as a camera sees it: the rectangle of pixels that it can touch, and rays in its frame.
#pragma once

#include <Eigen/Geometry>

#include "sensor/renderer/scene/object.hpp"
#include "sensor/renderer/view/camera.hpp"
#include "sensor/renderer/view/intersect.hpp"

namespace cleave::render {

// Pixel coordinates, both ends included; not clipped to the image.
struct PixelBounds {
  double x_low, x_high, y_low, y_high;
};

struct ObjectView {
  Eigen::Isometry3d object_from_camera;
  PixelBounds bounds;
  double nearest_depth_m;  // nothing of the object is nearer to the camera

  ObjectView(const Object& object, const Eigen::Isometry3d& table_from_camera,
             const Intrinsics& intrinsics);
};

// Whole pixels of an image: columns [x_begin, x_end), rows [y_begin, y_end).
struct PixelRectangle {
  std::uint32_t x_begin, x_end, y_begin, y_end;
};
[[nodiscard]] PixelRectangle pixels_within(const PixelBounds& bounds, const CameraModel& camera);

// The ray's direction through a pixel, with depth 1, so that a ray's parameter is a depth.
inline Eigen::Vector3d pixel_direction(double x, double y, const Intrinsics& intrinsics) {
  return {(x - intrinsics.cx) / intrinsics.fx, (y - intrinsics.cy) / intrinsics.fy, 1};
}

}  // namespace cleave::render
