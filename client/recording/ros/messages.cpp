// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/messages.hpp"

#include "recording/time_units.hpp"

namespace cleave::recording::ros {
namespace {

Header read_header(CdrReader& message) {
  if (message.is_ros1()) (void)message.number<std::uint32_t>();  // seq
  Header header;
  header.stamp_ns = message.number<std::int32_t>() * ns_per_s;
  header.stamp_ns += message.number<std::uint32_t>();
  header.frame_id = message.string();
  return header;
}

}  // namespace

CdrReader reader_of(ByteView message, Wire wire) {
  return wire == Wire::ros1 ? CdrReader::of_ros1(message) : CdrReader(message);
}

PointCloud2 read_point_cloud2(CdrReader message) {
  constexpr std::size_t smallest_field = 13;
  PointCloud2 cloud;
  cloud.header = read_header(message);
  cloud.height = message.number<std::uint32_t>();
  cloud.width = message.number<std::uint32_t>();
  for (std::size_t left = message.length(smallest_field); left > 0; --left) {
    PointField& field = cloud.fields.emplace_back();
    field.name = message.string();
    field.offset = message.number<std::uint32_t>();
    field.datatype = message.number<std::uint8_t>();
    field.count = message.number<std::uint32_t>();
  }
  cloud.is_bigendian = message.boolean();
  cloud.point_step = message.number<std::uint32_t>();
  cloud.row_step = message.number<std::uint32_t>();
  cloud.data = message.numbers<std::uint8_t>();
  return cloud;
}

Image read_image(CdrReader message) {
  Image image;
  image.header = read_header(message);
  image.height = message.number<std::uint32_t>();
  image.width = message.number<std::uint32_t>();
  image.encoding = message.string();
  image.is_bigendian = message.boolean();
  image.step = message.number<std::uint32_t>();
  image.data = message.numbers<std::uint8_t>();
  return image;
}

CameraInfo read_camera_info(CdrReader message) {
  CameraInfo info;
  info.header = read_header(message);
  info.height = message.number<std::uint32_t>();
  info.width = message.number<std::uint32_t>();
  info.distortion_model = message.string();
  info.d.resize(message.length(sizeof(double)));
  for (double& value : info.d) value = message.number<double>();
  for (double& value : info.k) value = message.number<double>();
  for (int i = 0; i < 9; ++i) (void)message.number<double>();  // R
  for (double& value : info.p) value = message.number<double>();
  info.binning_x = message.number<std::uint32_t>();
  info.binning_y = message.number<std::uint32_t>();
  info.roi_x = message.number<std::uint32_t>();
  info.roi_y = message.number<std::uint32_t>();
  info.roi_height = message.number<std::uint32_t>();
  info.roi_width = message.number<std::uint32_t>();
  return info;
}

}  // namespace cleave::recording::ros
