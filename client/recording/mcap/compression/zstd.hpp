// SPDX-License-Identifier: BSD-3-Clause
// The compression of the chunks that are written, and of most that are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "recording/mcap/compression/block.hpp"

namespace cleave::recording {

class ZstdCompressor {
 public:
  ZstdCompressor();
  ~ZstdCompressor();
  ZstdCompressor(const ZstdCompressor&) = delete;
  ZstdCompressor& operator=(const ZstdCompressor&) = delete;

  [[nodiscard]] Bytes compress(ByteView plain);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

// Throws DataError unless the result has exactly `plain_bytes`.
[[nodiscard]] Block zstd_decompress(ByteView compressed, std::size_t plain_bytes);

}  // namespace cleave::recording
