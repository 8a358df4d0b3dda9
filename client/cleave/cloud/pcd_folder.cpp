#include "cleave/cloud/pcd_folder.hpp"

#include <algorithm>

#include "cleave/cloud/pcd_header.hpp"
#include "cleave/console/natural_order.hpp"

namespace cleave::client {

std::vector<std::filesystem::path> pcd_files(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.path().extension() == ".pcd") files.push_back(entry.path());
  }
  if (files.empty()) throw PcdError(path.string() + ": there is no .pcd file in this folder");
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return files;
}

std::vector<std::filesystem::path> pcd_files(const std::vector<std::string>& paths) {
  std::vector<std::filesystem::path> files;
  for (const std::string& path : paths) {
    const auto more = pcd_files(std::filesystem::path(path));
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

}  // namespace cleave::client
