// SPDX-License-Identifier: BSD-3-Clause
// A pinhole camera in the frame of a cloud, and whether there are such cameras.
#pragma once

#include <Eigen/Core>

namespace cleave::segmentation {

// `projection` * (point - `centre`) is proportional to (column, row, 1), as stored; its last row is
// the direction of view, unit length, away from the camera.
struct Camera {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d projection = Eigen::Matrix3d::Identity();

  [[nodiscard]] Eigen::Vector3d view() const { return projection.row(2); }
  // Across the view, towards growing columns and rows, as long as a pixel is short.
  [[nodiscard]] Eigen::Vector3d right() const { return across(0); }
  [[nodiscard]] Eigen::Vector3d down() const { return across(1); }

 private:
  [[nodiscard]] Eigen::Vector3d across(int row) const {
    const Eigen::Vector3d axis = projection.row(row);
    return axis - axis.dot(view()) * view();
  }
};

// Pixels with right angles, and square, or so many times as long as wide as where columns or rows
// were left out.
[[nodiscard]] bool has_sound_pixels(const Camera& camera, bool square);

}  // namespace cleave::segmentation
