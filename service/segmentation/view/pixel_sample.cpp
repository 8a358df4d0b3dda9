#include "segmentation/view/pixel_sample.hpp"

#include <algorithm>

#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::uint32_t lines = 32;
constexpr std::size_t enough = 256;  // pixels
constexpr double far_m = 1e9;        // no product of what follows overflows

}  // namespace

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

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
          {.point = Eigen::Vector3d(p[0], p[1], p[2]).cwiseMax(-far_m).cwiseMin(far_m),
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
  if (pixels_.empty()) return;
  values_.resize(pixels_.size());
  const auto median = [this](auto&& value_of) {
    std::transform(pixels_.begin(), pixels_.end(), values_.begin(), value_of);
    return median_of(values_);
  };
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    middle_[axis] = median([axis](const SampledPixel& p) { return p.point[axis]; });
  }
  extent_m_ = median([this](const SampledPixel& p) { return (p.point - middle_).norm(); });
}

}  // namespace cleave::segmentation
