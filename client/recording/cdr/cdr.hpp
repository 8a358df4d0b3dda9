// SPDX-License-Identifier: BSD-3-Clause
// CDR as ROS 2 and DDS write it (XCDR1): numbers are aligned to their own size. We write it in
// little endian, and read either.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "recording/cdr/byte_order.hpp"
#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

class CdrWriter {
 public:
  CdrWriter();

  template <class Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    align(sizeof value);
    append_number(bytes_, value);
  }
  void boolean(bool value) { number(static_cast<std::uint8_t>(value)); }
  // Its length with the NUL, the characters, the NUL.
  void string(std::string_view text);
  // char[size]: the text, and NULs behind it. Throws DataError if no NUL fits.
  void characters(std::string_view text, std::size_t size);
  // The length of a sequence; its elements follow.
  void length(std::size_t count) { number(static_cast<std::uint32_t>(count)); }
  // Elements without anything between them: a sequence of numbers.
  template <class Number>
  void numbers(std::span<const Number> values) {
    length(values.size());
    align(sizeof(Number));
    append(bytes_, std::as_bytes(values));
  }

  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  void align(std::size_t size);
  Bytes bytes_;
};

// Throws DataError where a message is too short, or is no XCDR1.
class CdrReader {
 public:
  explicit CdrReader(ByteView message);
  // The serialisation of ROS 1: the same fields, in little endian, but without encapsulation,
  // padding and NULs.
  [[nodiscard]] static CdrReader of_ros1(ByteView message);

  template <class Number>
  [[nodiscard]] Number number() {
    align(sizeof(Number));
    const auto value = source_.number<Number>();
    return big_endian_ ? byte_swapped(value) : value;
  }
  [[nodiscard]] bool boolean() { return number<std::uint8_t>() != 0; }
  [[nodiscard]] std::string string();
  [[nodiscard]] std::string characters(std::size_t size);
  // The length of a sequence of elements that take `smallest_element` bytes or more: a length that
  // lies is found before anybody asks for memory.
  [[nodiscard]] std::size_t length(std::size_t smallest_element);
  [[nodiscard]] bool is_ros1() const { return ros1_; }
  // The elements of a sequence of numbers, in place, as bytes, in the byte order of the message.
  template <class Number>
  [[nodiscard]] ByteView numbers() {
    const std::size_t count = length(sizeof(Number));
    align(sizeof(Number));
    return source_.take(count * sizeof(Number));
  }

 private:
  CdrReader(ByteView body, bool big_endian, bool ros1);
  void align(std::size_t size);
  std::size_t size_;  // without the encapsulation
  ByteSource source_;
  bool big_endian_ = false;
  bool ros1_ = false;
};

}  // namespace cleave::recording
