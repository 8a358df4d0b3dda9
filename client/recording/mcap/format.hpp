// SPDX-License-Identifier: BSD-3-Clause
// The MCAP container, version 0 (mcap.dev/spec): the records that this library reads and writes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

// Begins and ends every file.
inline constexpr std::string_view mcap_magic{"\x89MCAP0\r\n", 8};

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F
};

// What applications may use for records of their own.
inline constexpr std::uint8_t first_private_opcode = 0x80;

// A record is its opcode, its length in 8 bytes, and its content.
inline constexpr std::size_t record_prefix_bytes = 9;
// Two offsets and a CRC, behind which newer writers may put more.
inline constexpr std::size_t footer_bytes = 20;

using Texts = std::map<std::string, std::string>;

struct Schema {
  std::uint16_t id = 0;  // 1 or more
  std::string name;
  std::string encoding;  // "ros2msg", "omgidl"
  std::string text;
  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  // 0: its messages have no schema
  std::string topic;
  std::string message_encoding;  // "cdr"
  Texts metadata;
  bool operator==(const Channel&) const = default;
};

struct MessageTimes {
  std::uint64_t log_ns = 0;      // when it was recorded, wall clock
  std::uint64_t publish_ns = 0;  // when it came about
};

struct Metadata {
  std::string name;
  Texts entries;
  std::uint64_t offset = 0;  // of the record in the file that it was read from
  bool operator==(const Metadata& other) const {
    return name == other.name && entries == other.entries;
  }
};

// A file within the file, without its data.
struct Attachment {
  std::uint64_t log_ns = 0;
  std::uint64_t create_ns = 0;  // 0: not known
  std::string name;
  std::string media_type;
  std::uint64_t data_bytes = 0;
  std::uint64_t offset = 0;  // of the record in the file that it was read from
  std::uint64_t length = 0;  // of the record's content, up to its CRC and with it
};

// What a file says of itself.
struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0;
  std::uint32_t attachments = 0;
  std::uint32_t metadata = 0;
  std::uint32_t chunks = 0;
  std::uint64_t start_ns = 0;  // of the messages
  std::uint64_t end_ns = 0;
  std::map<std::uint16_t, std::uint64_t> message_counts;  // by channel
};

// Where a chunk lies in the file, and which times are in it.
struct ChunkPlace {
  std::uint64_t offset = 0;  // of its opcode
  std::uint64_t length = 0;  // with opcode and length
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  bool loose = false;  // no chunk, but messages that stand one after the other outside of chunks
};

void append_record(Bytes& to, Opcode opcode, ByteView content);
void append_texts(Bytes& to, const Texts& texts);
// Numbers of messages, or offsets, by channel.
void append_by_channel(Bytes& to, const std::map<std::uint16_t, std::uint64_t>& numbers);

[[nodiscard]] Bytes encode(const Schema& schema);
[[nodiscard]] Bytes encode(const Channel& channel);
[[nodiscard]] Bytes encode(const Metadata& metadata);
[[nodiscard]] Bytes encode(const Statistics& statistics);

// From the content of a record; what follows the fields is passed over, as the format asks for.
// Throw DataError.
[[nodiscard]] Schema decode_schema(ByteView content);
[[nodiscard]] Channel decode_channel(ByteView content);
[[nodiscard]] Metadata decode_metadata(ByteView content);
[[nodiscard]] Statistics decode_statistics(ByteView content);
[[nodiscard]] Texts decode_texts(ByteSource& source);

// CRC-32 (ISO-HDLC) as MCAP uses it; `before` continues a sum.
[[nodiscard]] std::uint32_t crc32_of(ByteView bytes, std::uint32_t before = 0);

}  // namespace cleave::recording
