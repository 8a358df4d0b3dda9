// SPDX-License-Identifier: BSD-3-Clause
// The camera: how it projects, and where it stands.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

namespace cleave::render {

struct Intrinsics {
  double fx = 525, fy = 525, cx = 319.5, cy = 239.5;  // pixels
};

struct CameraModel {
  std::uint32_t width = 640;
  std::uint32_t height = 480;
  Intrinsics intrinsics;
};

// With square pixels, and the default's angle of view across.
[[nodiscard]] CameraModel camera_of_size(std::uint32_t width, std::uint32_t height);

// The same field of view with `factor` times as many columns and rows. `factor` > 0.
[[nodiscard]] CameraModel scaled(const CameraModel& camera, double factor);

// In the table frame. With yaw 0 the camera looks along +y, and down by its tilt.
struct CameraPose {
  double height_m = 0.6;   // above the table
  double tilt_rad = 0.68;  // downwards from horizontal
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;  // about the table's z, to the left
};

// From the camera's optical frame (x right, y down, z forward) to the table frame.
[[nodiscard]] Eigen::Isometry3d table_from_camera(const CameraPose& pose);

// A slow movement that looks at one point of the table all the while: up to 3 cm to either side,
// 2 cm up and forth. `phase` in [0, 1), 0 = `base`; smooth, and closed: phase 1 would be `base`.
[[nodiscard]] CameraPose pose_on_loop(const CameraPose& base, double phase);

}  // namespace cleave::render
