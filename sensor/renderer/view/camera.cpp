// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/camera.hpp"

#include <cmath>
#include <numbers>

namespace cleave::render {

CameraModel camera_of_size(std::uint32_t width, std::uint32_t height) {
  constexpr CameraModel usual;
  const double focal_length = usual.intrinsics.fx * width / usual.width;
  return {.width = width,
          .height = height,
          .intrinsics = {.fx = focal_length,
                         .fy = focal_length,
                         .cx = (width - 1) / 2.0,
                         .cy = (height - 1) / 2.0}};
}

CameraModel scaled(const CameraModel& camera, double factor) {
  // Integer coordinates are the middles of pixels: the image's border lies half a pixel outside.
  const Intrinsics& i = camera.intrinsics;
  return {.width = static_cast<std::uint32_t>(std::lround(camera.width * factor)),
          .height = static_cast<std::uint32_t>(std::lround(camera.height * factor)),
          .intrinsics = {.fx = i.fx * factor,
                         .fy = i.fy * factor,
                         .cx = (i.cx + 0.5) * factor - 0.5,
                         .cy = (i.cy + 0.5) * factor - 0.5}};
}

Eigen::Isometry3d table_from_camera(const CameraPose& pose) {
  const Eigen::AngleAxisd turn(pose.yaw_rad, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d right = turn * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d forward =
      turn * Eigen::Vector3d(0, std::cos(pose.tilt_rad), -std::sin(pose.tilt_rad));
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear().col(0) = right;
  transform.linear().col(1) = forward.cross(right);
  transform.linear().col(2) = forward;
  transform.translation() = Eigen::Vector3d(pose.x_m, pose.y_m, pose.height_m);
  return transform;
}

CameraPose pose_on_loop(const CameraPose& base, double phase) {
  const double angle = 2 * std::numbers::pi * phase;
  const double sideways_m = 0.03 * std::sin(angle);
  const double forth_m = 0.01 * (1 - std::cos(angle));
  const double up_m = 0.01 * (1 - std::cos(angle));

  const double to_target_m = base.height_m / std::tan(base.tilt_rad) - forth_m;
  CameraPose pose = base;
  pose.x_m += sideways_m * std::cos(base.yaw_rad) - forth_m * std::sin(base.yaw_rad);
  pose.y_m += sideways_m * std::sin(base.yaw_rad) + forth_m * std::cos(base.yaw_rad);
  pose.height_m += up_m;
  pose.yaw_rad += std::atan2(sideways_m, to_target_m);
  pose.tilt_rad = std::atan2(pose.height_m, std::hypot(sideways_m, to_target_m));
  return pose;
}

}  // namespace cleave::render
