// SPDX-License-Identifier: BSD-3-Clause
// Fields off a record that stays in its file: only what is asked for is read.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "recording/mcap/io/input_file.hpp"

namespace cleave::recording {

// As ByteSource. Throws DataError where the record ends too soon, FileError when the disk fails.
class FieldSource {
 public:
  FieldSource(const InputFile& file, std::uint64_t offset, std::uint64_t length)
      : file_(file), offset_(offset), left_(length) {}

  void skip(std::uint64_t count) {
    if (count > left_) {
      throw DataError("it ends " + std::to_string(count - left_) + " bytes too soon");
    }
    offset_ += count;
    left_ -= count;
  }
  template <class Number>
  [[nodiscard]] Number number() {
    const std::uint64_t at = offset_;
    skip(sizeof(Number));
    Number value{};
    file_.read(at, std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }
  [[nodiscard]] std::string string() {
    const auto size = number<std::uint32_t>();
    const std::uint64_t at = offset_;
    skip(size);
    const Bytes text = file_.read(at, size);
    return {reinterpret_cast<const char*>(text.data()), text.size()};
  }
  [[nodiscard]] std::uint64_t offset() const { return offset_; }
  [[nodiscard]] std::uint64_t left() const { return left_; }

 private:
  const InputFile& file_;
  std::uint64_t offset_;
  std::uint64_t left_;
};

}  // namespace cleave::recording
