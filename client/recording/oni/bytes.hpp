// SPDX-License-Identifier: BSD-3-Clause
// Little-endian values out of bytes that nobody vouches for.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

namespace cleave::oni {

static_assert(std::endian::native == std::endian::little, ".oni files are little-endian");

// Takes values from the front; empty where too few bytes are left.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  template <class T>
  [[nodiscard]] std::optional<T> take() {
    static_assert(std::is_arithmetic_v<T>);
    if (left_.size() < sizeof(T)) return std::nullopt;
    T value{};
    std::memcpy(&value, left_.data(), sizeof(T));
    left_ = left_.subspan(sizeof(T));
    return value;
  }
  [[nodiscard]] std::optional<std::span<const std::uint8_t>> take(std::size_t count) {
    if (left_.size() < count) return std::nullopt;
    const auto taken = left_.first(count);
    left_ = left_.subspan(count);
    return taken;
  }
  // A length of 4 bytes, and so many characters of which the last ones are zeros.
  [[nodiscard]] std::optional<std::string_view> take_text() {
    const auto length = take<std::uint32_t>();
    if (!length) return std::nullopt;
    const auto text = take(*length);
    if (!text) return std::nullopt;
    const std::string_view whole(reinterpret_cast<const char*>(text->data()), text->size());
    return whole.substr(0, whole.find('\0'));
  }
  [[nodiscard]] std::span<const std::uint8_t> left() const { return left_; }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace cleave::oni
