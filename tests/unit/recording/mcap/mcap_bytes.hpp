// SPDX-License-Identifier: BSD-3-Clause
// MCAP files record by record, as recorders of other people write them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "recording/mcap/format.hpp"

namespace cleave::recording {

// Records one after the other: a file, or what is in a chunk. Schema 1 and channel 1 (on "a/topic")
// are what most tests need. With `padding`, every record but messages has bytes behind its fields.
class McapBytes {
 public:
  explicit McapBytes(bool padding = false) : padding_(padding) {}

  McapBytes& magic();
  McapBytes& header(std::string_view profile = "");
  McapBytes& schema(std::uint16_t id = 1);
  McapBytes& channel(std::uint16_t id = 1, std::uint16_t schema_id = 1,
                     std::string_view topic = "a/topic");
  // Its data is its number, in 4 bytes, `repeat` times.
  McapBytes& message(std::uint32_t number, std::uint64_t log_ns, std::uint16_t channel_id = 1,
                     std::size_t repeat = 1);
  // Compression: "", "lz4" or "zstd". With `sum` the CRC of its records.
  McapBytes& chunk(const McapBytes& records, std::uint64_t start_ns, std::uint64_t end_ns,
                   std::string_view compression = "", bool sum = true);
  McapBytes& attachment(std::string_view name, std::string_view data);
  McapBytes& metadata(std::string_view name);
  McapBytes& record(std::uint8_t opcode, std::string_view content);
  // With the CRC of all before.
  McapBytes& data_end();
  McapBytes& statistics(std::uint64_t messages);
  // And the magic. `summary`: where it begins; 0 = there is none.
  McapBytes& footer(std::uint64_t summary = 0);

  [[nodiscard]] const Bytes& bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t size() const { return bytes_.size(); }

 private:
  void put(Opcode opcode, Bytes content);

  bool padding_;
  Bytes bytes_;
};

// Begun, with schema 1 and channel 1.
[[nodiscard]] McapBytes begun_file(bool padding = false);

}  // namespace cleave::recording
