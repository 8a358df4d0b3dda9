// SPDX-License-Identifier: BSD-3-Clause
// The clouds of a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::recording {

struct PcdFiles {
  std::vector<std::filesystem::path> files;   // *.pcd in natural order
  std::vector<std::filesystem::path> others;  // files with other extensions, in natural order
  std::string failure;                        // why the path cannot be looked into; empty if it can
};

// A folder's files, not those of folders in it, or the one file that the path names. A folder
// whose own name ends in .pcd is among `files`, for it will prove unreadable and be named.
[[nodiscard]] PcdFiles list_pcd_files(const std::filesystem::path& path);

// `path` itself, whatever its extension, if it is no folder; else the files that list_pcd_files()
// finds. Throws PcdError when there is none.
[[nodiscard]] std::vector<std::filesystem::path> pcd_files(const std::filesystem::path& path);
// Those of several files and folders, one after the other.
[[nodiscard]] std::vector<std::filesystem::path> pcd_files(const std::vector<std::string>& paths);

}  // namespace cleave::recording
