// SPDX-License-Identifier: BSD-3-Clause
// The messages of ROS that hold clouds, depth and cameras, as their fields.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "recording/cdr/cdr.hpp"

namespace cleave::recording::ros {

// How a channel's messages are written: its message encoding.
enum class Wire {
  cdr,  // ROS 2, "cdr"
  ros1  // a converted bag of ROS 1, "ros1"
};

[[nodiscard]] CdrReader reader_of(ByteView message, Wire wire);

// std_msgs/Header
struct Header {
  std::int64_t stamp_ns = 0;
  std::string frame_id;
};

// sensor_msgs/PointField
struct PointField {
  std::string name;
  std::uint32_t offset = 0;  // bytes from a point's first
  std::uint8_t datatype = 0;
  std::uint32_t count = 0;
};

// sensor_msgs/PointCloud2, but for is_dense: points are looked at, whatever it says.
struct PointCloud2 {
  Header header;
  std::uint32_t height = 0;  // 1 = unorganised
  std::uint32_t width = 0;
  std::vector<PointField> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0;  // bytes
  std::uint32_t row_step = 0;
  ByteView data;  // of the message
};

// sensor_msgs/Image
struct Image {
  Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding;
  bool is_bigendian = false;
  std::uint32_t step = 0;  // bytes from row to row
  ByteView data;           // of the message
};

// sensor_msgs/CameraInfo, but for R: depth is along the axis of the image that it lies in.
struct CameraInfo {
  Header header;
  std::uint32_t height = 0;  // of the whole sensor, before binning; 0 = not said
  std::uint32_t width = 0;
  std::string distortion_model;
  std::vector<double> d;
  std::array<double, 9> k{};    // row-major, of the raw image
  std::array<double, 12> p{};   // row-major, of the rectified one
  std::uint32_t binning_x = 0;  // 0 = 1
  std::uint32_t binning_y = 0;
  std::uint32_t roi_x = 0;  // in pixels before binning
  std::uint32_t roi_y = 0;
  std::uint32_t roi_height = 0;  // 0 = all
  std::uint32_t roi_width = 0;
};

// Throw DataError for a message that is too short. What the fields mean together is not checked.
[[nodiscard]] PointCloud2 read_point_cloud2(CdrReader message);
[[nodiscard]] Image read_image(CdrReader message);
[[nodiscard]] CameraInfo read_camera_info(CdrReader message);

}  // namespace cleave::recording::ros
