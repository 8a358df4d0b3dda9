// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string_view>

namespace cleave::recording {

// Writes the parts, one after the other, to a temporary file beside `file`, and renames it once all
// is on the disk: a full disk leaves what was there before. A symbolic link is followed.
// Throws std::runtime_error, naming the file and what to do, and removes the temporary file.
void replace_file(const std::filesystem::path& file,
                  std::initializer_list<std::span<const std::byte>> parts);

// Text, in the same way.
void replace_file(const std::filesystem::path& file, std::string_view text);

// With the folders above it; nothing happens where it is there already. Throws std::runtime_error,
// naming the folder and what to do.
void make_folder(const std::filesystem::path& folder);

}  // namespace cleave::recording
