// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/oni_reader.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "recording/oni/record_walk.hpp"
#include "recording/oni/text.hpp"

namespace cleave::oni {
namespace {

using recording::ByteSource;

// "NI10", version (1, 1, 2, 4 bytes), largest time stamp (8), largest node (4)
constexpr std::size_t file_header_bytes = 24;
constexpr std::uint32_t depth_node = 2;
// Fields of interest are shorter; OpenNI2 records tables of megabytes as properties, too.
constexpr std::size_t most_field_bytes = 1024;

struct FileHeader {
  bool wide;  // since 1.0.1, positions are of 8 bytes
};

FileHeader read_header(const File& file, std::vector<std::uint8_t>& buffer) {
  ByteSource bytes(std::as_bytes(file.read(0, file_header_bytes, buffer)));
  constexpr std::string_view expected = "NI10";
  const auto magic = bytes.try_take(expected.size());
  if (!magic || !std::ranges::equal(*magic, recording::bytes_of(expected))) {
    throw std::runtime_error("it is not an .oni file (it does not begin with NI10)");
  }
  const auto major = bytes.try_number<std::uint8_t>();
  const auto minor = bytes.try_number<std::uint8_t>();
  const auto maintenance = bytes.try_number<std::uint16_t>();
  const auto build = bytes.try_number<std::uint32_t>();
  if (!build || file.size() < file_header_bytes) throw std::runtime_error("it ends in its header");
  const auto version = std::tuple(*major, *minor, *maintenance, *build);
  if (version < std::tuple(1, 0, 0, 4) || version > std::tuple(1, 0, 1, 0)) {
    throw std::runtime_error("its format version " + std::to_string(*major) + "." +
                             std::to_string(*minor) + "." + std::to_string(*maintenance) + "." +
                             std::to_string(*build) + " is not within 1.0.0.4 to 1.0.1.0");
  }
  return {version >= std::tuple(1, 0, 1, 0)};
}

struct Node {
  std::uint32_t type;
  std::uint32_t codec;
};

std::optional<Node> parse_node(std::span<const std::uint8_t> fields) {
  ByteSource bytes(std::as_bytes(fields));
  if (!take_text(bytes)) return std::nullopt;
  const auto type = bytes.try_number<std::uint32_t>();
  const auto codec = bytes.try_number<std::uint32_t>();
  if (!codec) return std::nullopt;
  return Node{*type, *codec};
}

bool is_node(RecordType type) {
  return type == RecordType::node_added || type == RecordType::node_added_1_0_0_5 ||
         type == RecordType::node_added_1_0_0_4;
}

bool is_property(RecordType type) {
  return type == RecordType::integer_property || type == RecordType::general_property;
}

}  // namespace

Reader::Reader(const std::filesystem::path& path) : file_(path), name_(path.string()) {
  try {
    find_frames();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot read the recording '" + name_ + "': " + error.what());
  }
}

void Reader::find_frames() {
  RecordWalk walk(file_, file_header_bytes, read_header(file_, buffer_).wide);
  std::optional<StreamProperties> properties;
  std::uint32_t depth_id = 0;
  while (const std::optional<Record> record = walk.next()) {
    const auto fields = [&] {
      return file_.read(record->fields,
                        std::min<std::size_t>(record->fields_bytes, most_field_bytes), buffer_);
    };
    if (is_node(record->type) && !properties) {
      const std::optional<Node> node = parse_node(fields());
      if (!node || node->type != depth_node) continue;
      properties.emplace(node->codec);
      depth_id = record->node;
    } else if (!properties || record->node != depth_id) {
      continue;
    } else if (is_property(record->type)) {
      properties->add(fields());
    } else if (record->type == RecordType::new_data) {
      ByteSource bytes(std::as_bytes(fields()));
      const auto timestamp_us = bytes.try_number<std::uint64_t>();
      const auto index = bytes.try_number<std::uint32_t>();
      if (index) {
        frames_.push_back({record->payload, record->payload_bytes, *index, *timestamp_us});
      }
    }
  }
  if (!properties) throw std::runtime_error("it has no depth stream");
  stream_ = properties->stream();
  codec_ = properties->codec();
  if (!walk.damaged() && walk.ended()) return;
  damage_ = "the recording '" + name_ + (walk.damaged() ? "' is damaged" : "' was cut off") +
            "; whole frames in it: " + std::to_string(frames_.size());
}

std::optional<std::string> Reader::read(std::size_t i, DepthFrame& frame) {
  const Entry& entry = frames_.at(i);
  const auto problem = [&](const std::string& why) {
    return "frame " + std::to_string(i + 1) + " of " + std::to_string(frames_.size()) +
           " in the recording '" + name_ + "' cannot be used: " + why;
  };
  const auto data = file_.read(entry.position, entry.bytes, buffer_);
  if (data.size() != entry.bytes) return problem("the file cannot be read there any more");
  frame.timestamp_us = entry.timestamp_us;
  frame.index = entry.index;
  frame.depth.resize(std::size_t{stream_.width} * stream_.height);
  if (const auto why = decode(codec_, data, frame.depth)) return problem(*why);
  return std::nullopt;
}

}  // namespace cleave::oni
