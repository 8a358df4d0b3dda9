// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/camera.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace cleave::oni {
namespace {

recording::Intrinsics intrinsics_of(const DepthStream& stream) {
  recording::Intrinsics k = recording::intrinsics_from_fov(
      stream.sensor_width, stream.sensor_height, static_cast<float>(stream.horizontal_fov_rad),
      static_cast<float>(stream.vertical_fov_rad));
  if (k.fx == 0) throw std::runtime_error("it does not tell its camera's field of view");
  k.cx -= static_cast<float>(stream.cropping.x);
  k.cy -= static_cast<float>(stream.cropping.y);
  if (stream.mirrored) k.cx = static_cast<float>(stream.width - 1) - k.cx;
  return k;
}

}  // namespace

Camera::Camera(const Reader& reader, std::uint64_t max_points) : stream_(reader.stream()) {
  if (reader.size() == 0) throw std::runtime_error("it has no frame");
  if (std::uint64_t{stream_.width} * stream_.height > max_points) {
    throw std::runtime_error("its images have " + std::to_string(stream_.width) + " x " +
                             std::to_string(stream_.height) + " pixels, more than the " +
                             std::to_string(max_points) +
                             " that fit; --decimate makes a block of them into one");
  }
  intrinsics_ = intrinsics_of(stream_);
  projection_ = recording::DepthProjection(stream_.width, stream_.height, intrinsics_);
}

void Camera::turn_back(DepthFrame& frame) const {
  if (!stream_.mirrored) return;
  for (auto row = frame.depth.begin(); row != frame.depth.end(); row += stream_.width) {
    std::reverse(row, row + stream_.width);
  }
}

void Camera::write_points(const DepthFrame& frame, float* xyz) const {
  projection_.write_points({frame.depth.data(), stream_.width, stream_.height,
                            std::size_t{stream_.width} * sizeof(std::uint16_t), stream_.unit_m},
                           xyz);
}

}  // namespace cleave::oni
