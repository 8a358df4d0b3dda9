// SPDX-License-Identifier: BSD-3-Clause
// A file that is read at any place, and never past its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace cleave::oni {

class File {
 public:
  // Throws std::runtime_error unless `path` is a regular file that can be read.
  explicit File(const std::filesystem::path& path);
  ~File();
  File(File&& other) noexcept;
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  File& operator=(File&&) = delete;

  // As it was when the file was opened.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  // At most `count` bytes from `position`: fewer at the end of the file, or where the disk fails.
  // `buffer` is grown as needed; the result is valid until it is used again.
  [[nodiscard]] std::span<const std::uint8_t> read(std::uint64_t position, std::size_t count,
                                                   std::vector<std::uint8_t>& buffer) const;

 private:
  int descriptor_;
  std::uint64_t size_ = 0;
};

}  // namespace cleave::oni
