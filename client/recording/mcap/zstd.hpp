// The compression of chunks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "recording/mcap/bytes.hpp"

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

// Memory that is not touched until something is written there: a size that lies costs nothing.
class Block {
 public:
  Block() = default;
  explicit Block(std::size_t size)
      : bytes_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {}
  [[nodiscard]] std::span<std::byte> bytes() { return {bytes_.get(), size_}; }
  [[nodiscard]] ByteView view() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
};

// Throws DataError unless the result has exactly `plain_bytes`.
[[nodiscard]] Block zstd_decompress(ByteView compressed, std::size_t plain_bytes);

}  // namespace cleave::recording
