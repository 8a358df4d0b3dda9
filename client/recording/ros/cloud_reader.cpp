// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/cloud_reader.hpp"

#include <utility>

#include "recording/cloud/fit_intrinsics.hpp"
#include "recording/ros/depth_image.hpp"
#include "recording/ros/point_cloud.hpp"
#include "recording/ros/unusable.hpp"

namespace cleave::recording::ros {
namespace {

// Of the contract.
constexpr std::size_t longest_name = 63;

void describe(FrameHeader& to, const Header& header, std::uint32_t width, std::uint32_t height) {
  to.width = width;
  to.height = height;
  to.capture_time_ns = header.stamp_ns;
  to.coordinate_frame = header.frame_id.substr(0, longest_name);
}

void set_intrinsics(FrameHeader& to, const Intrinsics& k) {
  to.fx = k.fx;
  to.fy = k.fy;
  to.cx = k.cx;
  to.cy = k.cy;
}

}  // namespace

CloudReader::CloudReader(const std::filesystem::path& path, TopicUse topic, std::string sensor)
    : mcap_(path),
      topic_(std::move(topic)),
      sensor_(std::move(sensor)),
      cameras_(topic_.first_camera.value_or(RecordedCamera{})) {}

void CloudReader::rewind() {
  mcap_.limit(0, ~std::uint64_t{0});
  cameras_.clear();
  held_.reset();
  number_ = 0;
}

std::optional<Frame> CloudReader::next() {
  while (const auto held = next_held()) {
    try {
      return frame_of(*held);
    } catch (const Unusable& error) {
      note_loss(held->number, error.cause(), error.what());
    } catch (const DataError& error) {
      note_loss(held->number, "damaged", error.what());
    }
  }
  return std::nullopt;
}

// The next message of the topic. It is handed out when the one after it has been read, for only
// then has its CameraInfo come, on whichever side of the image it was recorded.
std::optional<CloudReader::Held> CloudReader::next_held() {
  while (const auto message = mcap_.next()) {
    if (message->channel->topic == topic_.camera_topic) note_camera(*message);
    if (message->channel->topic != topic_.topic) continue;
    Held held{++number_, message->times, {message->data.begin(), message->data.end()}};
    std::optional<Held> before = std::exchange(held_, std::move(held));
    if (before) return before;
  }
  return std::exchange(held_, std::nullopt);
}

void CloudReader::note_camera(const Message& message) {
  try {
    cameras_.add(recorded_camera(message, wire_of(message.channel->message_encoding)));
  } catch (const DataError& error) {
    problems_.add(topic_.camera_topic + ": " + error.what());
    ++losses_["damaged CameraInfo"];
  }
}

Frame CloudReader::frame_of(const Held& held) {
  Cloud cloud = topic_.kind == TopicKind::points ? points_cloud(held) : depth_cloud(held);
  cloud.header.frame_id = held.number;
  cloud.header.sensor = sensor_;
  const auto log_ns = static_cast<std::int64_t>(held.times.log_ns);
  if (cloud.header.capture_time_ns == 0) cloud.header.capture_time_ns = log_ns;
  return {log_ns, std::move(cloud)};
}

Cloud CloudReader::points_cloud(const Held& held) const {
  const PointCloud2 message =
      read_point_cloud2(reader_of(held.data, wire_of(topic_.message_encoding)));
  Cloud cloud{{}, points_of(message)};
  describe(cloud.header, message.header, message.width, message.height);
  set_intrinsics(cloud.header, fit_intrinsics(cloud.xyz.data(), message.width, message.height));
  return cloud;
}

Cloud CloudReader::depth_cloud(const Held& held) {
  const Image image = read_image(reader_of(held.data, wire_of(topic_.message_encoding)));
  const std::vector<float> depth_m = depth_of(image);
  const CameraInfo& info = cameras_.of_image(moment_of(image.header, held.times));
  const Camera camera = camera_of(info, kind_of(topic_.topic), image.width, image.height);
  Cloud cloud;
  describe(cloud.header, image.header, image.width, image.height);
  set_intrinsics(cloud.header, camera.intrinsics);
  cloud.xyz.resize(3 * depth_m.size());
  projection(cloud, camera.intrinsics).write_points(depth_m, cloud.xyz.data());
  return cloud;
}

const DepthProjection& CloudReader::projection(const Cloud& cloud, const Intrinsics& intrinsics) {
  const FrameHeader& header = cloud.header;
  if (intrinsics != intrinsics_ || header.width != width_ || header.height != height_) {
    intrinsics_ = intrinsics;
    width_ = header.width;
    height_ = header.height;
    projection_ = DepthProjection(width_, height_, intrinsics);
  }
  return projection_;
}

void CloudReader::note_loss(std::uint64_t number, const std::string& cause,
                            const std::string& why) {
  ++losses_[cause];
  problems_.add(topic_.topic + ", message " + std::to_string(number) + ": " + why);
}

std::vector<std::string> CloudReader::problems() const {
  return problems_.texts_after(mcap_.problems());
}

std::map<std::string, std::uint64_t> CloudReader::losses() const {
  std::map<std::string, std::uint64_t> losses = losses_;
  const Problems& damage = mcap_.contents().problems;
  if (!damage.empty()) losses["damaged"] += damage.count();
  return losses;
}

std::vector<std::string> CloudReader::remarks() const {
  if (topic_.why.empty()) return {};
  return {topic_.topic + ": " + topic_.why};
}

}  // namespace cleave::recording::ros
