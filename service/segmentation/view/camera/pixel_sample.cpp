// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/camera/pixel_sample.hpp"

#include <algorithm>

#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::uint32_t lines = 32;
constexpr std::size_t enough = 256;  // pixels

}  // namespace

void PixelSample::take(const CloudView& cloud, std::uint32_t wanted) {
  const std::uint32_t columns = std::min(wanted, cloud.width);
  const std::uint32_t rows = std::min(wanted, cloud.height);
  // In the middles of even intervals: the same from both ends.
  const auto place = [](std::uint32_t i, std::uint32_t count, std::uint32_t size) {
    return static_cast<std::uint32_t>((2 * std::uint64_t{i} + 1) * size /
                                      (2 * std::uint64_t{count}));
  };
  pixels_.clear();
  for (std::uint32_t level = 0; level < rows; ++level) {
    const std::uint32_t row = place(level, rows, cloud.height);
    for (std::uint32_t line = 0; line < columns; ++line) {
      const std::uint32_t column = place(line, columns, cloud.width);
      const float* p = cloud.point(std::size_t{row} * cloud.width + column);
      if (!is_measured(p)) continue;
      pixels_.push_back(
          {.point = Eigen::Vector3d(p[0], p[1], p[2]).cwiseMax(-farthest_m).cwiseMin(farthest_m),
           .column = static_cast<double>(column),
           .row = static_cast<double>(row),
           .line = line,
           .level = level});
    }
  }
}

void PixelSample::take(const CloudView& cloud) {
  take(cloud, lines);
  if (pixels_.size() < enough) take(cloud, max_lines);
}

void PixelSample::find_middle() {
  points_.clear();
  for (const SampledPixel& pixel : pixels_) points_.push_back(pixel.point);
  middle_ = middle_finder_.find(points_);
}

}  // namespace cleave::segmentation
