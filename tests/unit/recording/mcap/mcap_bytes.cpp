// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/recording/mcap/mcap_bytes.hpp"

#include <lz4frame.h>

#include <stdexcept>
#include <utility>

#include "recording/mcap/compression/zstd.hpp"

namespace cleave::recording {
namespace {

Bytes compressed(ByteView plain, std::string_view compression) {
  if (compression == "zstd") return ZstdCompressor().compress(plain);
  if (compression == "lz4") {
    Bytes result(LZ4F_compressFrameBound(plain.size(), nullptr));
    const std::size_t size =
        LZ4F_compressFrame(result.data(), result.size(), plain.data(), plain.size(), nullptr);
    if (LZ4F_isError(size) != 0U) throw std::runtime_error(LZ4F_getErrorName(size));
    result.resize(size);
    return result;
  }
  return {plain.begin(), plain.end()};
}

}  // namespace

void McapBytes::put(Opcode opcode, Bytes content) {
  if (padding_ && opcode != Opcode::message) append(content, bytes_of("\x01\xFF\xFF"));
  append_record(bytes_, opcode, content);
}

McapBytes& McapBytes::magic() {
  append(bytes_, bytes_of(mcap_magic));
  return *this;
}

McapBytes& McapBytes::header(std::string_view profile) {
  Bytes content;
  append_string(content, profile);
  append_string(content, "another library");
  put(Opcode::header, std::move(content));
  return *this;
}

McapBytes& McapBytes::schema(std::uint16_t id) {
  put(Opcode::schema, encode(Schema{id, "a/Type", "ros2msg", "uint32 number\n"}));
  return *this;
}

McapBytes& McapBytes::channel(std::uint16_t id, std::uint16_t schema_id, std::string_view topic) {
  put(Opcode::channel, encode(Channel{id, schema_id, std::string(topic), "cdr", {}}));
  return *this;
}

McapBytes& McapBytes::message(std::uint32_t number, std::uint64_t log_ns, std::uint16_t channel_id,
                              std::size_t repeat) {
  Bytes content;
  append_number(content, channel_id);
  append_number(content, number);
  append_number(content, log_ns);
  append_number(content, log_ns);
  for (std::size_t i = 0; i < repeat; ++i) append_number(content, number);
  put(Opcode::message, std::move(content));
  return *this;
}

McapBytes& McapBytes::chunk(const McapBytes& records, std::uint64_t start_ns, std::uint64_t end_ns,
                            std::string_view compression, bool sum) {
  const Bytes data = compressed(records.bytes(), compression);
  Bytes content;
  append_number(content, start_ns);
  append_number(content, end_ns);
  append_number(content, records.size());
  append_number(content, sum ? crc32_of(records.bytes()) : 0);
  append_string(content, compression);
  append_number(content, std::uint64_t{data.size()});
  append(content, data);
  put(Opcode::chunk, std::move(content));
  return *this;
}

McapBytes& McapBytes::attachment(std::string_view name, std::string_view data) {
  Bytes content;
  append_number(content, std::uint64_t{7});  // log time
  append_number(content, std::uint64_t{6});  // creation
  append_string(content, name);
  append_string(content, "text/plain");
  append_number(content, std::uint64_t{data.size()});
  append(content, bytes_of(data));
  append_number(content, crc32_of(content));
  put(Opcode::attachment, std::move(content));
  return *this;
}

McapBytes& McapBytes::metadata(std::string_view name) {
  put(Opcode::metadata, encode(Metadata{std::string(name), {{"key", "value"}}}));
  return *this;
}

McapBytes& McapBytes::record(std::uint8_t opcode, std::string_view content) {
  const ByteView bytes = bytes_of(content);
  put(Opcode{opcode}, {bytes.begin(), bytes.end()});
  return *this;
}

McapBytes& McapBytes::data_end() {
  Bytes content;
  append_number(content, crc32_of(bytes_));
  put(Opcode::data_end, std::move(content));
  return *this;
}

McapBytes& McapBytes::statistics(std::uint64_t messages) {
  Statistics statistics;
  statistics.messages = messages;
  put(Opcode::statistics, encode(statistics));
  return *this;
}

McapBytes& McapBytes::footer(std::uint64_t summary) {
  Bytes content;
  append_number(content, summary);
  append_number(content, std::uint64_t{0});  // no offsets of groups
  append_number(content, std::uint32_t{0});  // no CRC
  put(Opcode::footer, std::move(content));
  return magic();
}

McapBytes begun_file(bool padding) {
  McapBytes file(padding);
  file.magic().header().schema().channel();
  return file;
}

}  // namespace cleave::recording
