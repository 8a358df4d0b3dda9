// SPDX-License-Identifier: BSD-3-Clause
// The messages of ROS 2 that viewers know, as CDR.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "recording/cloud/projection.hpp"
#include "recording/frames/frame.hpp"
#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

// sensor_msgs/msg/Image, 16UC1. Stamp and frame of the header.
[[nodiscard]] Bytes image_message(const FrameHeader& header, std::span<const std::uint16_t> pixels);

struct ReceivedImage {
  std::uint32_t width;
  std::uint32_t height;
  std::vector<std::uint16_t> pixels;
};
// Throws DataError for anything but a 16UC1 image without gaps between its rows.
[[nodiscard]] ReceivedImage read_image(ByteView message);

// sensor_msgs/msg/CameraInfo of a camera without distortion.
[[nodiscard]] Bytes camera_info_message(const FrameHeader& header, const Intrinsics& intrinsics);
[[nodiscard]] Intrinsics read_camera_info(ByteView message);

// sensor_msgs/msg/PointCloud2 with x, y, z as float32.
[[nodiscard]] Bytes point_cloud_message(const Cloud& cloud);
// The points, 3 floats each. Throws DataError for any other layout.
[[nodiscard]] std::vector<float> read_point_cloud(ByteView message);

}  // namespace cleave::recording
