// The clouds of a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::client {

// `path` itself if it is no folder; else the .pcd files in it, in natural order.
// Throws PcdError when there is none.
[[nodiscard]] std::vector<std::filesystem::path> pcd_files(const std::filesystem::path& path);
// Those of several files and folders, one after the other.
[[nodiscard]] std::vector<std::filesystem::path> pcd_files(const std::vector<std::string>& paths);

}  // namespace cleave::client
