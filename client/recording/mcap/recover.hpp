// What is left of a damaged file, as a whole one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::recording {

struct Recovery {
  std::uint64_t messages = 0;
  std::vector<std::string> problems;  // what was lost, with byte offsets
};

// Copies every message and metadata record that is intact, with schemas and channels, into a new
// file. The damaged file is gone through from its beginning: its index is not asked.
// Throws FileError: `damaged` is no MCAP, both are one file, or `out` cannot be written.
[[nodiscard]] Recovery recover(const std::filesystem::path& damaged,
                               const std::filesystem::path& out);

}  // namespace cleave::recording
