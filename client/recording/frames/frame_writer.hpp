// SPDX-License-Identifier: BSD-3-Clause
// Frames into a recording: which topics, in which messages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "recording/cloud/depth_codec.hpp"
#include "recording/frames/frame.hpp"
#include "recording/mcap/writer.hpp"

namespace cleave::recording {

// For a sensor `camera`:
//   cleave/camera/cloud                  cleave::recording::Cloud, with every cloud
//   cleave/camera/depth/image            sensor_msgs/msg/Image, where depth gives the points back
//   cleave/camera/depth/camera_info      sensor_msgs/msg/CameraInfo, with it
//   cleave/camera/points                 sensor_msgs/msg/PointCloud2, where it does not
//   cleave/camera/labels                 cleave::recording::Labels, with every label map
//   cleave/camera/labels/image           sensor_msgs/msg/Image
//   cleave/camera/segments               cleave::v1::SegmentList
//   cleave/camera/segments/boxes         foxglove::SceneUpdate
//
// The messages of a frame have one log time and one number, and lie in one chunk. One thread at a
// time.
class FrameWriter {
 public:
  // Creates the file. Throws FileError.
  explicit FrameWriter(const std::filesystem::path& path,
                       std::size_t chunk_bytes = McapWriter::default_chunk);

  // Throws FileError when the file cannot be written; the frames since the last chunk are lost
  // then. Throws DataError for a frame that the contract does not allow.
  void write(const Frame& frame);
  // What was written so far is in the file, whatever happens to this process.
  void flush() { mcap_.flush(); }
  void add_metadata(const Metadata& metadata) { mcap_.add_metadata(metadata); }
  void add_attachment(const Attachment& attachment, ByteView content) {
    mcap_.add_attachment(attachment, content);
  }
  void close() { mcap_.close(); }

  [[nodiscard]] std::uint64_t size_bytes() const { return mcap_.size_bytes(); }

 private:
  enum class Type { image, camera_info, point_cloud, cloud, labels, segments, scene_update };
  void add(const Cloud& cloud);
  void add(const Labels& labels);
  void add(const SegmentList& list);
  void add(const FrameHeader& header, const char* topic, Type type, const Bytes& data);
  [[nodiscard]] std::uint16_t channel(const std::string& topic, Type type);
  [[nodiscard]] std::uint16_t schema(Type type);

  McapWriter mcap_;
  DepthEncoder encoder_;
  std::map<Type, std::uint16_t> schemas_;
  std::map<std::string, std::uint16_t> channels_;  // by topic
  std::uint64_t log_ns_ = 0;                       // of the frame that is being written
  std::uint32_t number_ = 0;
};

}  // namespace cleave::recording
