// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/folder.hpp"

#include <algorithm>

#include "recording/pcd/error.hpp"
#include "recording/pcd/natural_order.hpp"

namespace cleave::recording {
namespace {

namespace fs = std::filesystem;

constexpr char extension[] = ".pcd";

void sort_naturally(std::vector<fs::path>& files) {
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().native(), b.filename().native());
  });
}

}  // namespace

PcdFiles list_pcd_files(const fs::path& path) {
  PcdFiles result;
  std::error_code error;
  const auto add = [&](const fs::path& file) {
    (file.extension() == extension ? result.files : result.others).push_back(file);
  };
  if (!fs::exists(path, error)) {
    result.failure = error ? error.message() : "there is no such file or folder";
  } else if (!fs::is_directory(path, error)) {
    add(path);
  } else {
    fs::directory_iterator entry(path, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      std::error_code unknown;  // of a dangling link: a file that will prove unreadable
      const bool passed_over =
          entry->is_directory(unknown) && entry->path().extension() != extension;
      if (!passed_over) add(entry->path());
    }
    if (error) result.failure = error.message();
  }
  sort_naturally(result.files);
  sort_naturally(result.others);
  return result;
}

std::vector<fs::path> pcd_files(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  PcdFiles found = list_pcd_files(path);
  if (!found.failure.empty()) {
    throw PcdError(path, PcdCause::unreadable,
                   "this folder cannot be read: " + found.failure + "; name another");
  }
  if (found.files.empty()) {
    throw PcdError(path, PcdCause::unreadable,
                   "there is no .pcd file in this folder; name another, or a file");
  }
  return std::move(found.files);
}

std::vector<fs::path> pcd_files(const std::vector<std::string>& paths) {
  std::vector<fs::path> files;
  for (const std::string& path : paths) {
    const auto more = pcd_files(fs::path(path));
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

}  // namespace cleave::recording
