// SPDX-License-Identifier: BSD-3-Clause
// A file that is read from anywhere.
#pragma once

#include <cstdint>
#include <filesystem>

#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

class InputFile {
 public:
  // Throws FileError: it cannot be opened, or is no regular file.
  explicit InputFile(std::filesystem::path path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  // Throws FileError when the disk fails, DataError when the file ends before.
  void read(std::uint64_t offset, std::span<std::byte> into) const;
  [[nodiscard]] Bytes read(std::uint64_t offset, std::uint64_t count) const;

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

}  // namespace cleave::recording
