// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/frame_reader.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "recording/cdr/lacking_fields.hpp"
#include "recording/cloud/depth_codec.hpp"
#include "recording/frames/cloud_messages.hpp"
#include "recording/frames/label_messages.hpp"
#include "recording/frames/segment_list_message.hpp"
#include "recording/time_units.hpp"

namespace cleave::recording {
namespace {

constexpr std::string_view prefix = "cleave/";

struct TopicName {
  std::string sensor;
  std::string rest;
};

// "cleave/camera/depth/image" is "camera" and "depth/image"; empty for a topic that is not ours.
std::optional<TopicName> split(std::string_view topic) {
  if (!topic.starts_with(prefix)) return std::nullopt;
  topic.remove_prefix(prefix.size());
  const std::size_t slash = topic.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  return TopicName{std::string(topic.substr(0, slash)), std::string(topic.substr(slash + 1))};
}

// Beyond what a double can tell of nanoseconds since 1970, offsets are small and exact.
std::uint64_t offset_ns(double seconds) {
  constexpr double longest_s = 1e9;
  return static_cast<std::uint64_t>(
      std::llround(std::fmin(seconds, longest_s) * static_cast<double>(ns_per_s)));
}

}  // namespace

FrameReader::FrameReader(const std::filesystem::path& path, Selection selection)
    : mcap_(path), selection_(std::move(selection)) {
  if (mcap_.contents().chunks.empty() && mcap_.contents().metadata.empty()) {
    throw FileError(path.string() + ": holds no messages" +
                    (mcap_.problems().empty() ? "" : ": " + mcap_.problems().front()));
  }
  begin();
}

void FrameReader::rewind() {
  begin();
}

void FrameReader::begin() {
  const std::uint64_t start_ns = mcap_.start_ns();
  // Without a start, everything: a file may announce a later one than it has.
  mcap_.limit(selection_.start_s > 0 ? start_ns + offset_ns(selection_.start_s) : 0,
              selection_.end_s ? start_ns + offset_ns(*selection_.end_s) : ~std::uint64_t{0});
  parts_.clear();
}

double FrameReader::duration_s() const {
  return static_cast<double>(mcap_.end_ns() - mcap_.start_ns()) / static_cast<double>(ns_per_s);
}

std::vector<std::string> FrameReader::problems() const {
  return problems_.texts_after(mcap_.problems());
}

std::map<std::string, std::uint64_t> FrameReader::losses() const {
  const std::uint64_t damaged = mcap_.contents().problems.count() + problems_.count();
  if (damaged == 0) return {};
  return {{"damaged", damaged}};
}

std::optional<Frame> FrameReader::next() {
  while (const auto message = mcap_.next()) {
    try {
      if (auto frame = add(*message)) return frame;
    } catch (const DataError& error) {
      problems_.add(message->channel->topic + ", message " + std::to_string(message->sequence) +
                    ": " + error.what());
    }
  }
  return std::nullopt;
}

// The frame that this message completes, if it does.
std::optional<Frame> FrameReader::add(const Message& message) {
  const auto topic = split(message.channel->topic);
  if (!topic || message.channel->message_encoding != "cdr") return std::nullopt;
  if (!selection_.sensor.empty() && topic->sensor != selection_.sensor) return std::nullopt;
  Parts& parts = parts_[topic->sensor];
  if (parts.number != message.sequence) {
    parts = Parts();
    parts.number = message.sequence;
  }

  const auto time_ns = static_cast<std::int64_t>(message.times.log_ns);
  const std::string& name = topic->rest;
  if (wants(Kind::cloud)) {
    if (name == "depth/image") parts.depth = read_image(message.data);
    if (name == "depth/camera_info") parts.intrinsics = read_camera_info(message.data);
    if (name == "points") parts.points = read_point_cloud(message.data);
    if (name == "cloud") {
      return Frame{time_ns, complete_cloud(message, parts)};
    }
  }
  if (wants(Kind::labels)) {
    if (name == "labels/image") parts.labels = read_image(message.data);
    if (name == "labels") {
      return Frame{time_ns, complete_labels(message, parts)};
    }
  }
  if (wants(Kind::segments) && name == "segments") {
    return Frame{time_ns, read_segment_list(message.data, lacking_in(*message.schema))};
  }
  return std::nullopt;
}

const LackingFields& FrameReader::lacking_in(const Schema& schema) {
  const auto [known, is_new] = lacking_.try_emplace(&schema);
  if (is_new) known->second = lacking_fields(schema.text);
  if (known->second) return *known->second;
  throw DataError(
      "it was recorded with another version of the contract (idl/cleave_v1.idl); replay it with "
      "the version of Cleave that recorded it");
}

Cloud FrameReader::complete_cloud(const Message& message, Parts& parts) {
  CloudMessage received = read_cloud_message(message.data, lacking_in(*message.schema));
  Cloud cloud{std::move(received.header), {}};
  const FrameHeader& header = cloud.header;
  if (received.projection == Projection::none) {
    if (!parts.points) throw DataError("a cloud without its points");
    cloud.xyz = std::move(*std::exchange(parts.points, std::nullopt));
    if (cloud.xyz.size() != 3 * header.points()) {
      throw DataError("a cloud's points are not of its size");
    }
    return cloud;
  }
  if (!parts.depth || !parts.intrinsics) throw DataError("a cloud without its depth image");
  const DepthImage image{std::move(parts.depth->pixels), *parts.intrinsics, received.projection,
                         std::move(received.correction)};
  parts.depth.reset();
  cloud.xyz.resize(3 * header.points());
  decode(image, header.width, header.height, cloud.xyz.data());
  return cloud;
}

Labels FrameReader::complete_labels(const Message& message, Parts& parts) {
  Labels labels = read_labels_message(message.data, lacking_in(*message.schema));
  if (!parts.labels || parts.labels->pixels.size() != labels.header.points()) {
    throw DataError("a label map without its image");
  }
  labels.label = std::move(parts.labels->pixels);
  parts.labels.reset();
  return labels;
}

std::set<std::string> sensors_of(const Contents& contents) {
  std::set<std::string> sensors;
  for (const auto& [topic, count] : contents.message_counts) {
    if (const auto name = split(topic); name && count > 0) sensors.insert(name->sensor);
  }
  return sensors;
}

}  // namespace cleave::recording
