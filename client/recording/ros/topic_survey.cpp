// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/topic_survey.hpp"

#include <string_view>
#include <utility>

#include "recording/frames/frame.hpp"
#include "recording/ros/camera.hpp"
#include "recording/ros/depth_image.hpp"
#include "recording/ros/point_cloud.hpp"
#include "recording/ros/unusable.hpp"

namespace cleave::recording::ros {
namespace {

constexpr std::string_view ours = "cleave/";

// "sensor_msgs/msg/Image", "sensor_msgs/Image" and "sensor_msgs::msg::dds_::Image_" are
// "sensor_msgs/Image".
std::string plain_name(std::string type) {
  std::string plain;
  for (std::size_t at = 0; at < type.size(); ++at) {
    const bool is_separator = type.compare(at, 2, "::") == 0;
    plain += is_separator ? '/' : type[at];
    if (is_separator) ++at;
  }
  type = std::move(plain);
  for (const std::string_view part : {"/msg/", "/dds_/"}) {
    const std::size_t at = type.find(part);
    if (at != std::string::npos) type.replace(at, part.size(), "/");
  }
  if (type.ends_with('_')) type.pop_back();
  return type;
}

std::string_view namespace_of(std::string_view topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == std::string_view::npos ? "" : topic.substr(0, slash + 1);
}

std::string camera_topic_of(std::string_view image_topic) {
  return std::string(namespace_of(image_topic)) + "camera_info";
}

std::string why_not(const std::string& type) {
  if (type.empty()) return "has no schema, which would name its type";
  if (type == "sensor_msgs/CompressedImage") {
    return "compressed images are not read: record the raw topic, or republish it with "
           "image_transport";
  }
  return "is neither PointCloud2 nor Image";
}

// Empty for a cloud that can be streamed and recorded as it is.
std::string too_large(std::uint32_t width, std::uint32_t height) {
  if (std::uint64_t{width} * height <= capacity_points) return "";
  return std::to_string(width) + " x " + std::to_string(height) + " points, more than the " +
         capacity_text() +
         " that can be streamed and recorded; --decimate 2 makes four into one, and `cleave "
         "segment` takes them as they are";
}

}  // namespace

Wire wire_of(const std::string& message_encoding) {
  return message_encoding == "ros1" ? Wire::ros1 : Wire::cdr;
}

void TopicSurvey::add(const Message& message) {
  Seen& seen = seen_[message.channel->topic];
  if (++seen.use.messages == 1) {
    seen.use.topic = message.channel->topic;
    seen.use.type = message.schema == nullptr ? "" : message.schema->name;
    seen.use.message_encoding = message.channel->message_encoding;
    const std::string type = plain_name(seen.use.type);
    if (type == "cleave/recording/Cloud") seen.type = Type::cleave_cloud;
    if (type == "sensor_msgs/PointCloud2") seen.type = Type::point_cloud;
    if (type == "sensor_msgs/Image") seen.type = Type::image;
    if (type == "sensor_msgs/CameraInfo") seen.type = Type::camera_info;
    has_cleave_cloud_ = has_cleave_cloud_ || seen.type == Type::cleave_cloud;
  }
  if (seen.judged) return;
  try {
    judge(seen, message);
    seen.judged = true;
  } catch (const Unusable& error) {
    seen.use.why = error.what();
    seen.judged = true;
  } catch (const DataError& error) {
    seen.use.why = std::string("its messages are damaged: ") + error.what();
  }
}

// Throws Unusable, or DataError for a message that is damaged.
void TopicSurvey::judge(Seen& seen, const Message& message) {
  const std::string& encoding = seen.use.message_encoding;
  seen.use.why.clear();
  if (seen.type == Type::cleave_cloud) {
    seen.use.kind = TopicKind::cleave_cloud;
  } else if (seen.type == Type::other) {
    throw Unusable("type", why_not(plain_name(seen.use.type)));
  } else if (encoding != "cdr" && encoding != "ros1") {
    throw Unusable("encoding", "its messages are written as '" + encoding +
                                   "'; those of ROS, cdr and ros1, are read");
  } else if (seen.type == Type::point_cloud) {
    const PointCloud2 cloud = read_point_cloud2(reader_of(message.data, wire_of(encoding)));
    check_fields(cloud);
    seen.width = cloud.width;
    seen.height = cloud.height;
    seen.use.kind = TopicKind::points;
  } else if (seen.type == Type::image) {
    const Image image = read_image(reader_of(message.data, wire_of(encoding)));
    check_encoding(image);
    seen.width = image.width;
    seen.height = image.height;
    seen.use.kind = TopicKind::depth;
  } else {
    seen.camera = recorded_camera(message, wire_of(encoding));
    throw Unusable("type", "the camera of the images beside it");
  }
}

bool TopicSurvey::is_settled(const std::string& topic) const {
  const auto found = seen_.find(topic);
  if (found == seen_.end() || !found->second.judged) return false;
  if (found->second.use.kind != TopicKind::depth) return true;
  const auto camera = seen_.find(camera_topic_of(topic));
  return camera != seen_.end() && camera->second.camera;
}

// camera_info in the namespace of the image, else the only CameraInfo there.
const TopicSurvey::Seen* TopicSurvey::camera_of_topic(const std::string& image_topic) const {
  const auto named = seen_.find(camera_topic_of(image_topic));
  if (named != seen_.end() && named->second.camera) return &named->second;
  const Seen* only = nullptr;
  for (const auto& [topic, seen] : seen_) {
    if (!seen.camera || namespace_of(topic) != namespace_of(image_topic)) continue;
    if (only != nullptr) return nullptr;
    only = &seen;
  }
  return only;
}

TopicUse TopicSurvey::verdict(const Seen& seen) const {
  TopicUse use = seen.use;
  const bool is_part = use.topic.starts_with(ours) && has_cleave_cloud_;
  if (use.kind == TopicKind::none && is_part) use.why = "goes with the clouds of Cleave";
  if (use.kind == TopicKind::points) use.why = too_large(seen.width, seen.height);
  if (use.kind != TopicKind::depth) return use;
  const Seen* const camera = camera_of_topic(use.topic);
  if (camera == nullptr) {
    use.kind = TopicKind::none;
    use.why = "no CameraInfo: looked for " + camera_topic_of(use.topic);
    return use;
  }
  use.camera_topic = camera->use.topic;
  use.first_camera = camera->camera;
  try {
    use.why = camera_of(camera->camera->info, kind_of(use.topic), seen.width, seen.height).remark;
    const std::string size = too_large(seen.width, seen.height);
    use.why += (use.why.empty() || size.empty() ? "" : "; ") + size;
  } catch (const Unusable& error) {
    use.kind = TopicKind::none;
    use.why = error.what();
  }
  return use;
}

std::vector<TopicUse> TopicSurvey::topics() const {
  std::vector<TopicUse> uses;
  for (const auto& [topic, seen] : seen_) uses.push_back(verdict(seen));
  return uses;
}

}  // namespace cleave::recording::ros
