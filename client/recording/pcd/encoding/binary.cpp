// SPDX-License-Identifier: BSD-3-Clause
#include <liblzf/lzf.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "recording/pcd/encoding/body.hpp"

namespace cleave::recording {
namespace {

// LZF's densest code: 3 bytes that stand for 264.
constexpr std::uint64_t lzf_largest_ratio = 88;

struct Column {
  std::size_t from;  // byte in a stored point
  std::size_t to;    // byte in a point without padding
  std::size_t bytes;
};

std::vector<Column> columns_of(const PcdHeader& header) {
  std::vector<Column> columns;
  std::size_t from = 0;
  std::size_t to = 0;
  for (const PcdField& field : header.fields) {
    if (!field.is_padding()) {
      columns.push_back({from, to, field.bytes()});
      to += field.bytes();
    }
    from += field.bytes();
  }
  return columns;
}

// Copies points of `step` bytes each out of `stored`, and leaves their padding behind.
std::uint8_t* copy_points(std::span<const std::uint8_t> stored, std::size_t step,
                          const std::vector<Column>& columns, std::uint8_t* to) {
  for (std::size_t at = 0; at < stored.size(); at += step) {
    for (const Column& column : columns) {
      to = std::copy_n(stored.data() + at + column.from, column.bytes, to);
    }
  }
  return to;
}

struct Block {
  std::uint32_t packed;
  std::uint32_t unpacked;
};

// What the block says of itself, held against the file's size and what LZF can do.
Block read_block_sizes(PcdInput& input, const PcdHeader& header) {
  std::array<std::uint8_t, sizeof(Block)> bytes{};
  if (!input.read(bytes)) refuse_truncated(input, header, 0);
  Block block{};
  std::memcpy(&block, bytes.data(), sizeof block);
  const std::string packed = "its compressed block of " + std::to_string(block.packed) + " bytes ";
  if (block.packed > input.bytes_left()) {
    input.refuse(PcdCause::truncated, packed + "ends after " + std::to_string(input.bytes_left()) +
                                          ", so that none of its " +
                                          std::to_string(header.points()) +
                                          " points can be read; copy or record it again");
  }
  // liblzf reads a first byte whether there is one or not.
  if (block.packed == 0 || block.unpacked / lzf_largest_ratio > block.packed) {
    input.refuse(PcdCause::damaged_data, packed + "cannot unpack to " +
                                             std::to_string(block.unpacked) +
                                             "; copy or record it again");
  }
  return block;
}

// Some writers store padding as PCL does not: the fields that the unpacked size speaks of.
std::vector<PcdField> stored_fields(const PcdInput& input, const PcdHeader& header,
                                    const Block& block) {
  PcdHeader plain = header;
  plain.fields = without_padding(header.fields);
  if (block.unpacked == plain.points() * plain.point_bytes()) return plain.fields;
  if (block.unpacked == header.points() * header.point_bytes()) return header.fields;
  input.refuse(PcdCause::damaged_data, "the header promises " + std::to_string(header.points()) +
                                           " points of " + std::to_string(plain.point_bytes()) +
                                           " bytes, but its compressed block unpacks to " +
                                           std::to_string(block.unpacked) +
                                           " bytes; copy or record it again");
}

std::vector<std::uint8_t> unpack(PcdInput& input, const Block& block) {
  std::vector<std::uint8_t> packed(block.packed);
  std::vector<std::uint8_t> unpacked(block.unpacked);
  if (!input.read(packed) || lzf_decompress(packed.data(), block.packed, unpacked.data(),
                                            block.unpacked) != block.unpacked) {
    input.refuse(PcdCause::damaged_data,
                 "its compressed block is damaged, so that its points cannot be decoded; copy or "
                 "record it again");
  }
  return unpacked;
}

}  // namespace

std::vector<std::uint8_t> read_binary(PcdInput& input, const PcdHeader& header) {
  const std::size_t step = header.point_bytes();
  const std::uint64_t available = input.bytes_left() / step;
  if (header.points() > available) refuse_truncated(input, header, available);
  const std::vector<Column> columns = columns_of(header);
  const std::size_t plain_step = columns.back().to + columns.back().bytes;
  std::vector<std::uint8_t> data(header.points() * plain_step);
  if (plain_step == step) {
    if (!input.read(data)) refuse_truncated(input, header, 0);
    return data;
  }
  constexpr std::size_t points_at_once = 1024;
  std::vector<std::uint8_t> stored(points_at_once * step);
  std::uint8_t* to = data.data();
  for (std::uint64_t done = 0; done < header.points(); done += points_at_once) {
    const std::uint64_t count = std::min<std::uint64_t>(points_at_once, header.points() - done);
    const auto part = std::span(stored).first(count * step);
    if (!input.read(part)) refuse_truncated(input, header, done);
    to = copy_points(part, step, columns, to);
  }
  return data;
}

// All values of the first field, then all of the second, ..., as one LZF block behind its two
// sizes.
std::vector<std::uint8_t> read_compressed(PcdInput& input, const PcdHeader& header) {
  const Block block = read_block_sizes(input, header);
  PcdHeader stored = header;
  stored.fields = stored_fields(input, header, block);
  const std::vector<std::uint8_t> by_field = unpack(input, block);
  const std::vector<Column> columns = columns_of(stored);
  const std::size_t step = columns.back().to + columns.back().bytes;
  std::vector<std::uint8_t> data(header.points() * step);
  for (const Column& column : columns) {
    const std::uint8_t* from = by_field.data() + header.points() * column.from;
    for (std::size_t at = column.to; at < data.size(); at += step, from += column.bytes) {
      std::copy_n(from, column.bytes, data.data() + at);
    }
  }
  return data;
}

std::vector<PcdField> without_padding(std::vector<PcdField> fields) {
  std::erase_if(fields, [](const PcdField& field) { return field.is_padding(); });
  return fields;
}

void refuse_truncated(const PcdInput& input, const PcdHeader& header, std::uint64_t found) {
  input.refuse(PcdCause::truncated,
               "the header promises " + std::to_string(header.points()) + " points, but the file " +
                   "ends after " + std::to_string(found) +
                   "; it is cut off or its header is wrong: copy or record it again");
}

}  // namespace cleave::recording
