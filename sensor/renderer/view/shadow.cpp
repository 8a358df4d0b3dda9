// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/shadow.hpp"

#include <algorithm>
#include <cmath>

#include "sensor/renderer/view/object_view.hpp"

namespace cleave::render {
namespace {

// How far a shadow ray starts from its surface, so that it does not meet that surface again.
constexpr double lift_m = 1e-4;

// An object that may hide points from a source at (source_x_m, 0, 0) in the optical frame.
class Occluder {
 public:
  Occluder(const Object& object, double source_x_m, const Eigen::Isometry3d& table_from_camera,
           const CameraModel& camera)
      : shape_(object.shape),
        source_(source_x_m, 0, 0),
        camera_(camera),
        view_(object, table_from_camera * Eigen::Translation3d(source_), camera.intrinsics),
        object_from_camera_(view_.object_from_camera * Eigen::Translation3d(-source_)) {}

  // Where hidden points can be. The source sees a point of depth z at x - source_x fx / z.
  PixelRectangle pixels() const {
    const double shift = view_.nearest_depth_m > 0
                             ? source_.x() * camera_.intrinsics.fx / view_.nearest_depth_m
                             : std::copysign(static_cast<double>(camera_.width), source_.x());
    PixelBounds bounds = view_.bounds;
    bounds.x_low += std::min(0.0, shift);
    bounds.x_high += std::max(0.0, shift);
    return pixels_within(bounds, camera_);
  }

  // Point and normal in the optical frame, the point at column x.
  bool hides(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double x) const {
    if (point.z() < view_.nearest_depth_m) return false;
    const double x_in_source = x - source_.x() * camera_.intrinsics.fx / point.z();
    if (x_in_source < view_.bounds.x_low || x_in_source > view_.bounds.x_high) return false;
    const Eigen::Vector3d start = point + lift_m * normal;
    const Ray ray{object_from_camera_ * start, object_from_camera_.linear() * (source_ - start)};
    Hit hit;
    hit.t = 1;
    intersect(shape_, ray, hit);
    return hit.t < 1;
  }

 private:
  const Shape& shape_;
  Eigen::Vector3d source_;
  const CameraModel& camera_;
  ObjectView view_;  // as the source sees it
  Eigen::Isometry3d object_from_camera_;
};

void cast_shadow(const Occluder& occluder, const Intrinsics& intrinsics,
                 const std::vector<Eigen::Vector3f>& normals, RayCast& image) {
  const PixelRectangle pixels = occluder.pixels();
  for (std::uint32_t y = pixels.y_begin; y < pixels.y_end; ++y) {
    for (std::uint32_t x = pixels.x_begin; x < pixels.x_end; ++x) {
      const std::size_t i = std::size_t{y} * image.width + x;
      if (image.measurable[i] == 0) continue;
      const Eigen::Vector3d point = image.depth_m[i] * pixel_direction(x, y, intrinsics);
      if (occluder.hides(point, normals[i].cast<double>(), x)) image.measurable[i] = 0;
    }
  }
}

}  // namespace

void remove_shadows(const Scene& scene, const Eigen::Isometry3d& table_from_camera,
                    const CameraModel& camera, const std::vector<Eigen::Vector3f>& normals,
                    RayCast& image) {
  for (const double source_x_m : {projector_x_m, infrared_camera_x_m}) {
    for (const Object& object : scene.objects) {
      const Occluder occluder(object, source_x_m, table_from_camera, camera);
      cast_shadow(occluder, camera.intrinsics, normals, image);
    }
  }
}

}  // namespace cleave::render
