// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/frame_writer.hpp"

#include <stdexcept>

#include "recording/frames/cloud_messages.hpp"
#include "recording/frames/label_messages.hpp"
#include "recording/frames/ros_messages.hpp"
#include "recording/frames/scene_update.hpp"
#include "recording/frames/segment_list_message.hpp"
#include "recording/schemas/schemas.hpp"

namespace cleave::recording {
namespace {

void check_size(const FrameHeader& header, std::size_t values, std::size_t values_a_point) {
  const std::uint64_t points = header.points();
  if (points == 0 || points > capacity_points || values != points * values_a_point) {
    throw DataError(
        "a frame of " + std::to_string(header.width) + " x " + std::to_string(header.height) +
        " points cannot be recorded; the contract's frames have 1 to " + capacity_text() +
        " (`cleave convert --decimate` makes a block of them into one)");
  }
}

}  // namespace

FrameWriter::FrameWriter(const std::filesystem::path& path, std::size_t chunk_bytes)
    : mcap_(path, chunk_bytes) {}

void FrameWriter::write(const Frame& frame) {
  log_ns_ = static_cast<std::uint64_t>(frame.log_time_ns);
  ++number_;
  std::visit([this](const auto& content) { add(content); }, frame.content);
  mcap_.end_group();
}

// The message that completes a frame comes last.
void FrameWriter::add(const Cloud& cloud) {
  const FrameHeader& header = cloud.header;
  check_size(header, cloud.xyz.size(), 3);
  CloudMessage message{header, Projection::none, {}};
  if (auto image = encoder_.encode(cloud)) {
    add(header, "depth/image", Type::image, image_message(header, image->depth_mm));
    add(header, "depth/camera_info", Type::camera_info,
        camera_info_message(header, image->intrinsics));
    message.projection = image->projection;
    message.correction = std::move(image->correction);
  } else {
    add(header, "points", Type::point_cloud, point_cloud_message(cloud));
  }
  add(header, "cloud", Type::cloud, cloud_message(message));
}

void FrameWriter::add(const Labels& labels) {
  check_size(labels.header, labels.label.size(), 1);
  add(labels.header, "labels/image", Type::image, image_message(labels.header, labels.label));
  add(labels.header, "labels", Type::labels, labels_message(labels));
}

void FrameWriter::add(const SegmentList& list) {
  add(list.header, "segments/boxes", Type::scene_update, scene_update_message(list));
  add(list.header, "segments", Type::segments, segment_list_message(list));
}

void FrameWriter::add(const FrameHeader& header, const char* topic, Type type, const Bytes& data) {
  const MessageTimes times{log_ns_, static_cast<std::uint64_t>(header.capture_time_ns)};
  mcap_.write(channel("cleave/" + header.sensor + "/" + topic, type), number_, times, data);
}

std::uint16_t FrameWriter::channel(const std::string& topic, Type type) {
  const auto found = channels_.find(topic);
  if (found != channels_.end()) return found->second;
  const std::uint16_t id = mcap_.add_channel(schema(type), topic, "cdr");
  channels_[topic] = id;
  return id;
}

std::uint16_t FrameWriter::schema(Type type) {
  const auto found = schemas_.find(type);
  if (found != schemas_.end()) return found->second;
  const auto add = [&](const char* name, const char* encoding, const std::string& text) {
    return schemas_[type] = mcap_.add_schema(name, encoding, text);
  };
  switch (type) {
    case Type::image:
      return add("sensor_msgs/msg/Image", "ros2msg", image_schema);
    case Type::camera_info:
      return add("sensor_msgs/msg/CameraInfo", "ros2msg", camera_info_schema);
    case Type::point_cloud:
      return add("sensor_msgs/msg/PointCloud2", "ros2msg", point_cloud_schema);
    case Type::cloud:
      return add("cleave::recording::Cloud", "omgidl", recording_schema);
    case Type::labels:
      return add("cleave::recording::Labels", "omgidl", recording_schema);
    case Type::segments:
      return add("cleave::v1::SegmentList", "omgidl", contract_schema);
    case Type::scene_update:
      return add("foxglove::SceneUpdate", "omgidl", scene_update_schema);
  }
  throw std::logic_error("a message of no type");
}

}  // namespace cleave::recording
