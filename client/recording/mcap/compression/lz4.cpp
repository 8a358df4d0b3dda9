// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/compression/lz4.hpp"

#include <lz4frame.h>

#include <memory>
#include <new>
#include <string>

namespace cleave::recording {
namespace {

using Context = std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)>;

Context make_context() {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0U) {
    throw std::bad_alloc();
  }
  return {context, &LZ4F_freeDecompressionContext};
}

}  // namespace

Block lz4_decompress(ByteView compressed, std::size_t plain_bytes) {
  const Context context = make_context();
  Block block(plain_bytes);
  std::size_t filled = 0;
  std::size_t expected = 1;  // more input; 0 = a frame has ended
  while (!compressed.empty()) {
    std::size_t taken = compressed.size();
    std::size_t made = plain_bytes - filled;
    expected = LZ4F_decompress(context.get(), block.bytes().data() + filled, &made,
                               compressed.data(), &taken, nullptr);
    if (LZ4F_isError(expected) != 0U) {
      throw DataError(std::string("lz4 cannot decompress it: ") + LZ4F_getErrorName(expected));
    }
    compressed = compressed.subspan(taken);
    filled += made;
    if (taken == 0 && made == 0) {
      throw DataError("it holds more than the " + std::to_string(plain_bytes) +
                      " bytes that it announces");
    }
  }
  if (expected != 0 && plain_bytes > 0) throw DataError("its lz4 data ends too soon");
  if (filled != plain_bytes) {
    throw DataError("it holds " + std::to_string(filled) + " bytes and announces " +
                    std::to_string(plain_bytes));
  }
  return block;
}

}  // namespace cleave::recording
