// SPDX-License-Identifier: BSD-3-Clause
// A block of bytes of which nobody knows yet how many will be used.
#pragma once

#include <cstddef>
#include <memory>

#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

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

}  // namespace cleave::recording
