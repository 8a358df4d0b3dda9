// SPDX-License-Identifier: BSD-3-Clause
// Little-endian numbers in and out of byte buffers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recording/error.hpp"

namespace cleave::recording {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

using Bytes = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

inline ByteView bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

inline void append(Bytes& to, ByteView bytes) {
  // Not insert(), about which GCC 12 warns wrongly.
  if (bytes.empty()) return;
  const std::size_t before = to.size();
  to.resize(before + bytes.size());
  std::memcpy(to.data() + before, bytes.data(), bytes.size());
}

template <class Number>
void append_number(Bytes& to, Number value) {
  append(to, std::as_bytes(std::span(&value, 1)));
}

// MCAP's strings: a length of 4 bytes, then the characters.
inline void append_string(Bytes& to, std::string_view text) {
  append_number(to, static_cast<std::uint32_t>(text.size()));
  append(to, bytes_of(text));
}

// Takes numbers off the front of a buffer; throws DataError where it ends too soon.
class ByteSource {
 public:
  explicit ByteSource(ByteView bytes) : rest_(bytes) {}

  [[nodiscard]] ByteView take(std::uint64_t count) {
    if (count > rest_.size()) {
      throw DataError("it ends " + std::to_string(count - rest_.size()) + " bytes too soon");
    }
    const ByteView taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(static_cast<std::size_t>(count));
    return taken;
  }
  template <class Number>
  [[nodiscard]] Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  [[nodiscard]] std::string string() {
    const ByteView text = take(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(text.data()), text.size()};
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  ByteView rest_;
};

}  // namespace cleave::recording
