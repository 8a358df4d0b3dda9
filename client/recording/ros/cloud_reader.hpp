// SPDX-License-Identifier: BSD-3-Clause
// The clouds of one topic that another recorder wrote.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "recording/cloud/depth_to_points.hpp"
#include "recording/frames/frame_input.hpp"
#include "recording/problems.hpp"
#include "recording/ros/camera.hpp"
#include "recording/ros/topic_survey.hpp"

namespace cleave::recording::ros {

// Every message of the topic that can be is a cloud, of any size, in the order of the file:
// - of PointCloud2 its x, y, z as they are, in metres by ROS's convention;
// - of a depth Image the points of a pinhole camera, by the arithmetic of the grabber, with the
//   CameraInfo of CameraBook.
// A frame's number is that of its message on the topic, from 1; its capture time and coordinate
// frame are those of the message's header. Deterministic.
class CloudReader : public FrameInput {
 public:
  // `topic` as TopicSurvey found it usable; `sensor` names the sensor. Throws FileError.
  CloudReader(const std::filesystem::path& path, TopicUse topic, std::string sensor);

  [[nodiscard]] std::optional<Frame> next() override;
  void rewind() override;
  [[nodiscard]] std::vector<std::string> problems() const override;
  [[nodiscard]] std::map<std::string, std::uint64_t> losses() const override;
  [[nodiscard]] std::vector<std::string> remarks() const override;

 private:
  // A message of the topic, kept until its CameraInfo must have come.
  struct Held {
    std::uint64_t number = 0;
    MessageTimes times;
    Bytes data;
  };
  [[nodiscard]] std::optional<Held> next_held();
  void note_camera(const Message& message);
  [[nodiscard]] Frame frame_of(const Held& held);
  [[nodiscard]] Cloud points_cloud(const Held& held) const;
  [[nodiscard]] Cloud depth_cloud(const Held& held);
  [[nodiscard]] const DepthProjection& projection(const Cloud& cloud, const Intrinsics& intrinsics);
  void note_loss(std::uint64_t number, const std::string& cause, const std::string& why);

  McapReader mcap_;
  TopicUse topic_;
  std::string sensor_;
  CameraBook cameras_;
  std::uint64_t number_ = 0;  // of the topic's last message
  std::optional<Held> held_;
  // Of the last image, for most have the same.
  DepthProjection projection_;
  Intrinsics intrinsics_;
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;

  Problems problems_;  // beyond the container's
  std::map<std::string, std::uint64_t> losses_;
};

}  // namespace cleave::recording::ros
