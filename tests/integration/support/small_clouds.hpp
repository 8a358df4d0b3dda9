// SPDX-License-Identifier: BSD-3-Clause
// Small clouds for tests of the stream, where the content hardly matters: two planes that meet.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

namespace cleave::test {

// width x height points, x, y, z: a floor and a wall one metre away.
inline std::vector<float> corner_points(std::uint32_t width, std::uint32_t height) {
  std::vector<float> xyz;
  for (std::uint32_t v = 0; v < height; ++v) {
    for (std::uint32_t u = 0; u < width; ++u) {
      const float x = (static_cast<float>(u) / static_cast<float>(width) - 0.5F);
      const float y = (static_cast<float>(v) / static_cast<float>(height) - 0.5F);
      const float z = y < 0.1F ? 1.0F : 1.0F - (y - 0.1F);
      xyz.insert(xyz.end(), {x * z, y * z, z});
    }
  }
  return xyz;
}

inline void write_pcd(const std::filesystem::path& file, std::uint32_t width,
                      std::uint32_t height) {
  std::ofstream out(file);
  out << "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH "
      << width << "\nHEIGHT " << height << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << width * height
      << "\nDATA ascii\n";
  const std::vector<float> xyz = corner_points(width, height);
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    out << xyz[i] << ' ' << xyz[i + 1] << ' ' << xyz[i + 2] << '\n';
  }
}

}  // namespace cleave::test
