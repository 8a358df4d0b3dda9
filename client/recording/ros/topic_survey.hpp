// SPDX-License-Identifier: BSD-3-Clause
// Which topics of a recording can be clouds, and why the others cannot.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "recording/mcap/reader.hpp"
#include "recording/ros/camera_book.hpp"

namespace cleave::recording::ros {

enum class TopicKind {
  cleave_cloud,  // clouds of `cleave record`: cleave/SENSOR/cloud
  points,        // PointCloud2
  depth,         // Image of depth, with a CameraInfo
  none           // cannot be segmented
};

struct TopicUse {
  std::string topic;
  std::string type;              // the schema's name
  std::string message_encoding;  // of the channel
  std::uint64_t messages = 0;    // so far
  TopicKind kind = TopicKind::none;
  std::string why;                             // it cannot be segmented; a remark where it can
  std::string camera_topic;                    // of `depth`
  std::optional<RecordedCamera> first_camera;  // of `depth`

  [[nodiscard]] bool usable() const { return kind != TopicKind::none; }
};

// Looks at the messages of a recording one by one. A topic is judged by its first message that is
// not damaged, and by nothing but its own messages and its camera's.
class TopicSurvey {
 public:
  void add(const Message& message);

  // All topics so far, by name, with their verdicts.
  [[nodiscard]] std::vector<TopicUse> topics() const;
  // Whether more messages can change what is said of `topic`.
  [[nodiscard]] bool is_settled(const std::string& topic) const;
  // Whether a cloud of `cleave record` was seen.
  [[nodiscard]] bool has_cleave_cloud() const { return has_cleave_cloud_; }

 private:
  enum class Type { cleave_cloud, point_cloud, image, camera_info, other };
  struct Seen {
    TopicUse use;
    Type type = Type::other;
    bool judged = false;
    std::uint32_t width = 0;  // of its clouds
    std::uint32_t height = 0;
    std::optional<RecordedCamera> camera;  // of a CameraInfo
  };
  static void judge(Seen& seen, const Message& message);
  // The CameraInfo topic of an image's topic; null if there is none.
  [[nodiscard]] const Seen* camera_of_topic(const std::string& image_topic) const;
  [[nodiscard]] TopicUse verdict(const Seen& seen) const;

  std::map<std::string, Seen> seen_;
  bool has_cleave_cloud_ = false;
};

// Of a topic that can be decoded: the serialisation of its messages.
[[nodiscard]] Wire wire_of(const std::string& message_encoding);

}  // namespace cleave::recording::ros
