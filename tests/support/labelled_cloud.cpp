#include "tests/support/labelled_cloud.hpp"

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cleave::tests {
namespace {

std::size_t offset_of(const pcl::PCLPointCloud2& cloud, const std::string& field,
                      const std::filesystem::path& file) {
  for (const auto& known : cloud.fields) {
    if (known.name == field) return known.offset;
  }
  throw std::runtime_error("cannot load " + file.string() + ": it has no field " + field);
}

template <typename Value>
Value value_at(const pcl::PCLPointCloud2& cloud, std::size_t point, std::size_t offset) {
  Value value;
  std::memcpy(&value, cloud.data.data() + point * cloud.point_step + offset, sizeof value);
  return value;
}

std::string_view take_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(),
                                    [](unsigned char c) { return std::isdigit(c) != 0; });
  auto digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

bool natural_less(std::string_view a, std::string_view b) {
  const auto starts_with_digit = [](std::string_view s) {
    return std::isdigit(static_cast<unsigned char>(s.front())) != 0;
  };
  while (!a.empty() && !b.empty()) {
    if (starts_with_digit(a) && starts_with_digit(b)) {
      const auto x = take_number(a);
      const auto y = take_number(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

}  // namespace

LabelledCloud load_labelled_cloud(const std::filesystem::path& file) {
  pcl::PCLPointCloud2 blob;
  if (pcl::PCDReader().read(file.string(), blob) != 0) {
    throw std::runtime_error("cannot load " + file.string() + ": PCL cannot read it");
  }
  const std::size_t x = offset_of(blob, "x", file);
  const std::size_t y = offset_of(blob, "y", file);
  const std::size_t z = offset_of(blob, "z", file);
  const std::size_t label = offset_of(blob, "label", file);

  LabelledCloud cloud;
  cloud.width = blob.width;
  cloud.height = blob.height;
  for (std::size_t i = 0; i < std::size_t{blob.width} * blob.height; ++i) {
    for (const std::size_t offset : {x, y, z}) {
      cloud.xyz.push_back(value_at<float>(blob, i, offset));
    }
    cloud.label.push_back(value_at<std::uint32_t>(blob, i, label));
  }
  return cloud;
}

std::vector<std::filesystem::path> list_clouds(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".pcd") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const auto& l, const auto& r) {
    return natural_less(l.filename().string(), r.filename().string());
  });
  return files;
}

std::optional<std::filesystem::path> find_data(const std::filesystem::path& folder) {
  const char* chosen = std::getenv("CLEAVE_DATA");
  const auto path = std::filesystem::path(chosen != nullptr ? chosen : CLEAVE_DATA) / folder;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

}  // namespace cleave::tests
