// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/compression/zstd.hpp"

#include <zstd.h>

#include <new>
#include <string>

namespace cleave::recording {
namespace {

// Depth images: 2.6 ms a frame; level 1 makes them 4 % larger in 2.2 ms, level 5 8 % smaller
// in 5.9.
constexpr int level = 3;

}  // namespace

struct ZstdCompressor::Context {
  ZSTD_CCtx* context = ZSTD_createCCtx();
};

ZstdCompressor::ZstdCompressor() : context_(std::make_unique<Context>()) {
  if (context_->context == nullptr) throw std::bad_alloc();
}

ZstdCompressor::~ZstdCompressor() {
  ZSTD_freeCCtx(context_->context);
}

Bytes ZstdCompressor::compress(ByteView plain) {
  Bytes result(ZSTD_compressBound(plain.size()));
  const std::size_t size = ZSTD_compressCCtx(context_->context, result.data(), result.size(),
                                             plain.data(), plain.size(), level);
  if (ZSTD_isError(size) != 0) {
    throw DataError(std::string("zstd cannot compress: ") + ZSTD_getErrorName(size));
  }
  result.resize(size);
  return result;
}

Block zstd_decompress(ByteView compressed, std::size_t plain_bytes) {
  Block block(plain_bytes);
  const std::size_t size =
      ZSTD_decompress(block.bytes().data(), plain_bytes, compressed.data(), compressed.size());
  if (ZSTD_isError(size) != 0) {
    throw DataError(std::string("zstd cannot decompress it: ") + ZSTD_getErrorName(size));
  }
  if (size != plain_bytes) {
    throw DataError("it holds " + std::to_string(size) + " bytes and announces " +
                    std::to_string(plain_bytes));
  }
  return block;
}

}  // namespace cleave::recording
