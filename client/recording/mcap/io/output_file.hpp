// SPDX-License-Identifier: BSD-3-Clause
// A file that grows record by record, and never keeps half of one.
#pragma once

#include <cstdint>
#include <filesystem>

#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

class OutputFile {
 public:
  // Creates the file, or empties it. Throws FileError.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Appends all bytes, or none: what a full disk let through is cut off again. Throws FileError.
  void append(ByteView bytes);
  // The bytes are on the disk, and stay there when the power fails. Throws FileError.
  void sync();

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] std::uint32_t crc() const { return crc_; }  // of all bytes so far
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail(int error) const;
  std::filesystem::path path_;
  int descriptor_;
  std::uint64_t size_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace cleave::recording
