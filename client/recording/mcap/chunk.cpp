// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/chunk.hpp"

#include <algorithm>
#include <string>

#include "recording/mcap/compression/lz4.hpp"
#include "recording/mcap/compression/zstd.hpp"
#include "recording/mcap/format.hpp"

namespace cleave::recording {
namespace {

// Far beyond what recorders make: a few bytes can be those of any number of zeros.
constexpr std::uint64_t largest_chunk = std::uint64_t{1} << 30U;

Block copy(ByteView data) {
  Block block(data.size());
  std::ranges::copy(data, block.bytes().begin());
  return block;
}

// Throws DataError.
Block unpack(const std::string& compression, ByteView data, std::uint64_t plain_bytes) {
  if (compression == "zstd") return zstd_decompress(data, static_cast<std::size_t>(plain_bytes));
  if (compression == "lz4") return lz4_decompress(data, static_cast<std::size_t>(plain_bytes));
  if (compression.empty()) return copy(data);
  throw DataError("its compression '" + compression +
                  "' is none of MCAP's own; have its recorder write zstd or lz4");
}

}  // namespace

Block plain_records(ByteView content) {
  ByteSource source(content);
  (void)source.take(2 * sizeof(std::uint64_t));  // the times
  const auto plain_bytes = source.number<std::uint64_t>();
  const auto crc = source.number<std::uint32_t>();
  const std::string compression = source.string();
  const ByteView data = source.take(source.number<std::uint64_t>());
  if (plain_bytes > largest_chunk) {
    throw DataError("it announces " + std::to_string(plain_bytes) +
                    " bytes, and at most 1 GiB is read in one chunk");
  }
  Block block = unpack(compression, data, plain_bytes);
  if (crc != 0 && crc32_of(block.view()) != crc) throw DataError("its CRC is wrong");
  return block;
}

}  // namespace cleave::recording
