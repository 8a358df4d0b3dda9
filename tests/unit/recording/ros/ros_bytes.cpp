// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/recording/ros/ros_bytes.hpp"

namespace cleave::recording::ros {
namespace {

constexpr std::size_t encapsulation_bytes = 4;

}  // namespace

RosBytes::RosBytes(Format format) : format_(format) {
  if (format == Format::ros1) return;
  const auto order = static_cast<std::byte>(format == Format::cdr_le ? 1 : 0);
  bytes_ = {std::byte{0}, order, std::byte{0}, std::byte{0}};
}

template <class Number>
RosBytes& RosBytes::number(Number value) {
  if (format_ != Format::ros1) {
    while ((bytes_.size() - encapsulation_bytes) % sizeof value != 0) {
      bytes_.push_back(std::byte{0xEE});
    }
  }
  append(bytes_, bytes_of_number(value, format_ == Format::cdr_be));
  return *this;
}

RosBytes& RosBytes::u8(std::uint8_t value) {
  return number(value);
}
RosBytes& RosBytes::u32(std::uint32_t value) {
  return number(value);
}
RosBytes& RosBytes::f64(double value) {
  return number(value);
}

RosBytes& RosBytes::text(const std::string& text) {
  const bool nul = format_ != Format::ros1;
  u32(static_cast<std::uint32_t>(text.size() + (nul ? 1 : 0)));
  append(bytes_, recording::bytes_of(text));
  if (nul) bytes_.push_back(std::byte{0});
  return *this;
}

RosBytes& RosBytes::bytes(const Bytes& data) {
  u32(static_cast<std::uint32_t>(data.size()));
  append(bytes_, data);
  return *this;
}

RosBytes& RosBytes::header(std::int64_t stamp_ns, const std::string& frame_id) {
  if (format_ == Format::ros1) u32(77);  // seq
  u32(static_cast<std::uint32_t>(stamp_ns / 1'000'000'000));
  u32(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000));
  return text(frame_id);
}

Bytes bytes_of_cloud(const CloudSpec& cloud, Format format) {
  RosBytes out(format);
  out.header(cloud.stamp_ns).u32(cloud.height).u32(cloud.width);
  out.u32(static_cast<std::uint32_t>(cloud.fields.size()));
  for (const Field& field : cloud.fields) {
    out.text(field.name).u32(field.offset).u8(field.datatype).u32(field.count);
  }
  out.u8(cloud.big_endian ? 1 : 0).u32(cloud.point_step).u32(cloud.row_step);
  return out.bytes(cloud.data).u8(0).result();
}

CloudSpec cloud_of(const std::vector<float>& xyz, std::uint32_t width, std::uint32_t height) {
  CloudSpec cloud;
  cloud.width = width;
  cloud.height = height;
  cloud.row_step = 12 * width;
  const ByteView bytes = std::as_bytes(std::span(xyz));
  cloud.data.assign(bytes.begin(), bytes.end());
  return cloud;
}

Bytes bytes_of_image(const ImageSpec& image, Format format) {
  RosBytes out(format);
  out.header(image.stamp_ns).u32(image.height).u32(image.width).text(image.encoding);
  return out.u8(image.big_endian ? 1 : 0).u32(image.step).bytes(image.data).result();
}

Bytes bytes_of_camera(const CameraSpec& camera, Format format) {
  RosBytes out(format);
  out.header(camera.stamp_ns).u32(camera.height).u32(camera.width).text("plumb_bob");
  out.u32(static_cast<std::uint32_t>(camera.d.size()));
  for (const double d : camera.d) out.f64(d);
  for (const double k : camera.k) out.f64(k);
  for (int i = 0; i < 9; ++i) out.f64(i % 4 == 0 ? 1 : 0);
  for (const double p : camera.p) out.f64(p);
  out.u32(camera.binning_x).u32(camera.binning_y).u32(camera.roi_x).u32(camera.roi_y);
  return out.u32(camera.roi_height).u32(camera.roi_width).u8(0).result();
}

Bag& Bag::add(const std::string& topic, const std::string& type, std::int64_t log_ns,
              const Bytes& message) {
  if (!schemas_.contains(type)) schemas_[type] = writer_.add_schema(type, "ros2msg", "");
  if (!channels_.contains(topic)) {
    channels_[topic] = writer_.add_channel(schemas_[type], topic, encoding_);
  }
  const auto time = static_cast<std::uint64_t>(log_ns);
  writer_.write(channels_[topic], 0, {time, time}, message);
  writer_.end_group();
  return *this;
}

}  // namespace cleave::recording::ros
