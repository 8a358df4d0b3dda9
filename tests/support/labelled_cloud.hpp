// Clouds with true labels, for tests that judge a segmentation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "segmentation/cloud_view.hpp"

namespace cleave::tests {

struct LabelledCloud {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> xyz;            // 3 a point
  std::vector<std::uint32_t> label;  // 0 = not labelled

  [[nodiscard]] segmentation::CloudView view() const { return {xyz.data(), 3, width, height}; }
};

// Reads a PCD file with the fields x, y, z and label; throws std::runtime_error that names the file
// and what is wrong with it.
[[nodiscard]] LabelledCloud load_labelled_cloud(const std::filesystem::path& file);

// The PCD files of a folder in natural order: learn2 before learn10. Empty if there is no folder.
[[nodiscard]] std::vector<std::filesystem::path> list_clouds(const std::filesystem::path& folder);

// A folder below CLEAVE_DATA: the environment variable, else what CMake was told, else
// ../shared/data beside the project. Nothing if it does not exist.
[[nodiscard]] std::optional<std::filesystem::path> find_data(const std::filesystem::path& folder);

}  // namespace cleave::tests
