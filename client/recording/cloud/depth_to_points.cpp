// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/depth_to_points.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "recording/cloud/measured.hpp"

namespace cleave::recording {
namespace {

std::vector<float> rays(std::uint32_t size, float focal_length, float principal_point) {
  std::vector<float> slopes(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    slopes[i] = static_cast<float>((static_cast<double>(i) - principal_point) / focal_length);
  }
  return slopes;
}

bool is_angle_of_view(float angle_rad) {
  return angle_rad > 0 && angle_rad < std::numbers::pi_v<float>;
}

float focal_length(std::uint32_t size, float angle_rad) {
  return static_cast<float>(size / (2 * std::tan(static_cast<double>(angle_rad) / 2)));
}

}  // namespace

DepthProjection::DepthProjection(std::uint32_t width, std::uint32_t height,
                                 const Intrinsics& intrinsics)
    : column_(rays(width, intrinsics.fx, intrinsics.cx)),
      row_(rays(height, intrinsics.fy, intrinsics.cy)) {}

void DepthProjection::write_points(const DepthRows& image, float* xyz) const {
  for (std::uint32_t v = 0; v < image.height; ++v) {
    const std::uint16_t* const depth =
        image.depth + v * (image.stride_bytes / sizeof(std::uint16_t));
    for (std::uint32_t u = 0; u < image.width; ++u, xyz += 3) {
      const float z = depth[u] == 0 ? no_measurement : static_cast<float>(depth[u]) * image.unit_m;
      xyz[0] = column_[u] * z;
      xyz[1] = row_[v] * z;
      xyz[2] = z;
    }
  }
}

void DepthProjection::write_points(std::span<const float> depth_m, float* xyz) const {
  std::size_t i = 0;
  for (const float row : row_) {
    for (const float column : column_) {
      const float z = depth_m[i++];
      xyz[0] = column * z;
      xyz[1] = row * z;
      xyz[2] = z;
      xyz += 3;
    }
  }
}

Intrinsics intrinsics_from_fov(std::uint32_t width, std::uint32_t height, float horizontal_rad,
                               float vertical_rad) {
  if (!is_angle_of_view(horizontal_rad) || !is_angle_of_view(vertical_rad)) return {};
  return {focal_length(width, horizontal_rad), focal_length(height, vertical_rad),
          static_cast<float>(width - 1) / 2, static_cast<float>(height - 1) / 2};
}

}  // namespace cleave::recording
