// SPDX-License-Identifier: BSD-3-Clause
// The records of an .oni file, one after the other, around those that are damaged.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "recording/oni/file.hpp"

namespace cleave::oni {

// Those that a reader of depth must know; values as OpenNI2 writes them (OniDataRecords.h).
enum class RecordType : std::uint32_t {
  node_added_1_0_0_4 = 0x02,
  integer_property = 0x03,
  real_property = 0x04,
  general_property = 0x06,
  new_data = 0x0A,
  end = 0x0B,
  node_added_1_0_0_5 = 0x0C,
  node_added = 0x0D,
  seek_table = 0x0E  // the last one
};

struct Record {
  RecordType type;
  std::uint32_t node;
  std::uint64_t fields;  // position in the file
  std::uint32_t fields_bytes;
  std::uint64_t payload;  // position in the file; within it, as its size
  std::uint32_t payload_bytes;
};

// A record is
//   magic "NIR\0", type, node, size of header and fields, size of the payload (4 bytes each),
//   position of the record that it undoes (8 bytes; 4 before version 1.0.1), fields, payload.
// Sizes are believed only where record and file agree. Where no record begins in its place, the
// walk goes back to behind the start of the one before, whose sizes may have lied, and looks for
// the next magic. Linear in the size of the file.
class RecordWalk {
 public:
  // `first`: where the first record begins. `wide`: version 1.0.1 or later.
  RecordWalk(const File& file, std::uint64_t first, bool wide);

  // Empty after the end record, or where there is nothing more.
  [[nodiscard]] std::optional<Record> next();
  // Bytes that were no record were passed over, to one that begins behind them.
  [[nodiscard]] bool damaged() const { return damaged_; }
  // The file has its end record: it was not cut off.
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  [[nodiscard]] std::optional<Record> record_at(std::uint64_t position);
  [[nodiscard]] std::optional<std::uint64_t> find_magic(std::uint64_t from);

  const File& file_;
  std::uint64_t position_;
  std::uint64_t search_from_;  // where to look for a magic if there is none at position_
  std::uint32_t header_bytes_;
  bool damaged_ = false;
  bool ended_ = false;
  std::vector<std::uint8_t> header_;
  // What was searched last, kept because the next search often begins within it.
  std::vector<std::uint8_t> block_buffer_;
  std::span<const std::uint8_t> block_;
  std::uint64_t block_position_ = 0;
};

}  // namespace cleave::oni
