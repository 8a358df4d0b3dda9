// SPDX-License-Identifier: BSD-3-Clause
// Little-endian numbers in and out of byte buffers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
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

// Takes numbers off the front of a buffer that nobody vouches for. Where it ends too soon, take()
// and what has no name with `try` throw DataError; try_take() and the like are empty, and the
// buffer is as it was.
class ByteSource {
 public:
  explicit ByteSource(ByteView bytes) : rest_(bytes) {}

  [[nodiscard]] std::optional<ByteView> try_take(std::uint64_t count) {
    if (count > rest_.size()) return std::nullopt;
    const ByteView taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(static_cast<std::size_t>(count));
    return taken;
  }
  [[nodiscard]] ByteView take(std::uint64_t count) {
    if (const auto taken = try_take(count)) return *taken;
    throw DataError("it ends " + std::to_string(count - rest_.size()) + " bytes too soon");
  }
  template <class Number>
  [[nodiscard]] std::optional<Number> try_number() {
    const auto taken = try_take(sizeof(Number));
    if (!taken) return std::nullopt;
    return number_in<Number>(*taken);
  }
  template <class Number>
  [[nodiscard]] Number number() {
    return number_in<Number>(take(sizeof(Number)));
  }
  [[nodiscard]] std::string string() {
    const ByteView text = take(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(text.data()), text.size()};
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  template <class Number>
  [[nodiscard]] static Number number_in(ByteView bytes) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    Number value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }

  ByteView rest_;
};

}  // namespace cleave::recording
