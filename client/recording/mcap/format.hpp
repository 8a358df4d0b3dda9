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
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F
};

// A record is its opcode, its length in 8 bytes, and its content.
inline constexpr std::size_t record_prefix_bytes = 9;
// Two offsets and a CRC.
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
  std::uint16_t schema_id = 0;
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
  bool operator==(const Metadata&) const = default;
};

// Where a chunk lies in the file, and what the index says of it.
struct ChunkPlace {
  std::uint64_t offset = 0;  // of its opcode
  std::uint64_t length = 0;  // with opcode and length
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
};

void append_record(Bytes& to, Opcode opcode, ByteView content);
void append_texts(Bytes& to, const Texts& texts);

[[nodiscard]] Bytes encode(const Schema& schema);
[[nodiscard]] Bytes encode(const Channel& channel);
[[nodiscard]] Bytes encode(const Metadata& metadata);

// From the content of a record. Throw DataError.
[[nodiscard]] Schema decode_schema(ByteView content);
[[nodiscard]] Channel decode_channel(ByteView content);
[[nodiscard]] Metadata decode_metadata(ByteView content);
[[nodiscard]] Texts decode_texts(ByteSource& source);

// CRC-32 (ISO-HDLC) as MCAP uses it; `before` continues a sum.
[[nodiscard]] std::uint32_t crc32_of(ByteView bytes, std::uint32_t before = 0);

}  // namespace cleave::recording
