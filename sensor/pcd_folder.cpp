#include "sensor/pcd_folder.hpp"

#include <algorithm>

#include "sensor/natural_order.hpp"

namespace cleave::sensor {
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

}  // namespace cleave::sensor
