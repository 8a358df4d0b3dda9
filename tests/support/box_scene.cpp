// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/box_scene.hpp"

#include <Eigen/Geometry>
#include <array>
#include <limits>

namespace cleave::tests {
namespace {

// Table frame: z up, the table is the rectangle z = 0 within +-0.5 m; the camera is above y < 0.
const std::array<Eigen::AlignedBox3d, 3> solids = {
    Eigen::AlignedBox3d(Eigen::Vector3d(-0.5, -0.5, -0.1), Eigen::Vector3d(0.5, 0.5, 0)),
    Eigen::AlignedBox3d(Eigen::Vector3d(-0.15, -0.05, 0), Eigen::Vector3d(0, 0.1, 0.15)),
    Eigen::AlignedBox3d(Eigen::Vector3d(0, -0.12, 0), Eigen::Vector3d(0.15, 0.06, 0.07))};
const Eigen::Vector3d camera_position(0.05, -0.75, 0.65);
constexpr double tilt_rad = 0.7;  // down from horizontal

// Distance along the ray to where it enters the box; infinity if it misses (slab method).
double distance_to(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& ray) {
  const Eigen::Array3d a = (box.min() - camera_position).array() / ray.array();
  const Eigen::Array3d b = (box.max() - camera_position).array() / ray.array();
  const double enter = a.min(b).maxCoeff();
  const double leave = a.max(b).minCoeff();
  return enter > 0 && enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

}  // namespace

evaluation::LabelledCloud render_touching_boxes(std::uint32_t width, std::uint32_t height) {
  // Columns: the camera's right, down and forward.
  Eigen::Matrix3d table_from_camera;
  table_from_camera << 1, 0, 0, 0, -std::sin(tilt_rad), std::cos(tilt_rad), 0, -std::cos(tilt_rad),
      -std::sin(tilt_rad);
  const double focal_length = 0.82 * width;

  evaluation::LabelledCloud cloud{.width = width, .height = height, .xyz = {}, .label = {}};
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const Eigen::Vector3d ray((column + 0.5 - width / 2.0) / focal_length,
                                (row + 0.5 - height / 2.0) / focal_length, 1);
      double depth = std::numeric_limits<double>::infinity();
      std::uint32_t label = 0;
      for (std::uint32_t s = 0; s < solids.size(); ++s) {
        const double distance = distance_to(solids[s], table_from_camera * ray);
        if (distance >= depth) continue;
        depth = distance;
        label = s + 1;
      }
      for (int axis = 0; axis < 3; ++axis) {
        cloud.xyz.push_back(label == 0 ? std::numeric_limits<float>::quiet_NaN()
                                       : static_cast<float>(ray[axis] * depth));
      }
      cloud.label.push_back(label);
    }
  }
  return cloud;
}

}  // namespace cleave::tests
