// Reads a PCD file. The only file here that knows PCL.
#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "sensor/pcd_header.hpp"
#include "sensor/source.hpp"

namespace cleave::sensor {

struct PointCloud {
  std::uint32_t width = 0;
  std::uint32_t height = 0;  // 1 = unorganised
  std::vector<float> xyz;    // width * height points, row-major
  Intrinsics intrinsics;     // of an organised cloud, where they explain its points
};

// The coordinates are the file's, bit for bit (doubles are rounded to float); a point with a
// coordinate that is not finite becomes NaN NaN NaN, and so does 0 0 0. Other fields are passed
// over.
[[nodiscard]] std::variant<PointCloud, PcdProblem> read_pcd(const std::filesystem::path& file);

}  // namespace cleave::sensor
