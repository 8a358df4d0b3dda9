// SPDX-License-Identifier: BSD-3-Clause
// What is left of a damaged file, as a whole one.
#pragma once

#include <cstdint>
#include <filesystem>

#include "recording/problems.hpp"

namespace cleave::recording {

struct Recovery {
  std::uint64_t messages = 0;
  std::uint64_t attachments = 0;
  std::uint64_t metadata = 0;
  Problems problems;  // what is damaged, with byte offsets
};

// Copies every message, attachment and metadata record that is intact into a new file, in the order
// of the old one, with all schemas and channels and the ids that they have. A file that is whole
// is copied whole. An attachment is held in memory while it is copied.
// Throws FileError: `damaged` is no MCAP, both are one file, or `out` cannot be written.
[[nodiscard]] Recovery recover(const std::filesystem::path& damaged,
                               const std::filesystem::path& out);

}  // namespace cleave::recording
