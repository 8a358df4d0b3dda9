// SPDX-License-Identifier: BSD-3-Clause
#include "console/picture/depth_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recording/cloud/measured.hpp"
#include "recording/percentile.hpp"

namespace cleave {
namespace {

DepthImage blank(std::uint32_t width, std::uint32_t height) {
  const std::size_t pixels = std::size_t{width} * height;
  return {width, height, std::vector<float>(pixels, std::numeric_limits<float>::quiet_NaN()),
          std::vector<std::uint16_t>(pixels, 0)};
}

struct Range {
  float low;
  float high;
  [[nodiscard]] float length() const { return high - low; }
};

// What 99 % of the values span, so that a few stray points do not shrink the rest to a dot.
Range robust_range(std::vector<float> values) {
  return {recording::percentile(values, 0.005), recording::percentile(values, 0.995)};
}

// Pixel = scale * (x, y) / (z + pull_back) + centre.
struct Pinhole {
  float pull_back_m = 0;
  float scale = 1;
  float centre_column = 0;
  float centre_row = 0;
};

// A cloud with points behind the sensor is looked at from behind all of them.
float pull_back_of(const PointsView& cloud, const std::vector<std::size_t>& measured) {
  std::vector<float> depths;
  depths.reserve(measured.size());
  for (const std::size_t i : measured) depths.push_back(cloud.point(i)[2]);
  const float nearest = *std::min_element(depths.begin(), depths.end());
  if (nearest > 0) return 0;
  const float distance_m = std::max(1.0F, 2 * robust_range(depths).length());
  return distance_m - nearest;
}

Pinhole fit_pinhole(const PointsView& cloud, const std::vector<std::size_t>& measured,
                    ImageSize size) {
  Pinhole pinhole;
  pinhole.pull_back_m = pull_back_of(cloud, measured);
  std::vector<float> columns;
  std::vector<float> rows;
  for (const std::size_t i : measured) {
    const float* p = cloud.point(i);
    columns.push_back(p[0] / (p[2] + pinhole.pull_back_m));
    rows.push_back(p[1] / (p[2] + pinhole.pull_back_m));
  }
  const Range u = robust_range(std::move(columns));
  const Range v = robust_range(std::move(rows));
  constexpr float filled = 0.9F;  // of the image, the rest is margin
  constexpr float smallest = 1e-6F;
  const auto width = static_cast<float>(size.width);
  const auto height = static_cast<float>(size.height);
  pinhole.scale = filled * std::min(width / std::max(u.length(), smallest),
                                    height / std::max(v.length(), smallest));
  pinhole.centre_column = width / 2 - pinhole.scale * (u.low + u.high) / 2;
  pinhole.centre_row = height / 2 - pinhole.scale * (v.low + v.high) / 2;
  return pinhole;
}

// Edge of the square that a point paints: as large as the points are apart, 5 pixels at most.
int splat_edge(std::size_t points, ImageSize size) {
  const double pixels = static_cast<double>(size.width) * size.height;
  return std::clamp(static_cast<int>(std::sqrt(pixels / static_cast<double>(points))), 1, 5);
}

void paint(DepthImage& image, float column, float row, int edge, float depth_m,
           std::uint16_t label) {
  // Compared as floats first: a stray point may lie further out than an int can say.
  const auto width = static_cast<int>(image.width);
  const auto height = static_cast<int>(image.height);
  if (!(column > -8 && column < static_cast<float>(width + 8) && row > -8 &&
        row < static_cast<float>(height + 8))) {
    return;
  }
  const int left = static_cast<int>(std::lround(column)) - edge / 2;
  const int top = static_cast<int>(std::lround(row)) - edge / 2;
  for (int y = std::max(top, 0); y < std::min(top + edge, height); ++y) {
    for (int x = std::max(left, 0); x < std::min(left + edge, width); ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x);
      if (image.depth_m[pixel] <= depth_m) continue;  // false where nothing is painted yet: NaN
      image.depth_m[pixel] = depth_m;
      image.label[pixel] = label;
    }
  }
}

DepthImage project(const PointsView& cloud, std::span<const std::uint16_t> labels, ImageSize size) {
  DepthImage image = blank(size.width, size.height);
  std::vector<std::size_t> measured;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (recording::is_measured(cloud.point(i))) measured.push_back(i);
  }
  if (measured.empty()) return image;
  const Pinhole pinhole = fit_pinhole(cloud, measured, size);
  const int edge = splat_edge(measured.size(), size);
  for (const std::size_t i : measured) {
    const float* p = cloud.point(i);
    const float depth_m = p[2] + pinhole.pull_back_m;
    paint(image, pinhole.scale * p[0] / depth_m + pinhole.centre_column,
          pinhole.scale * p[1] / depth_m + pinhole.centre_row, edge, depth_m, labels[i]);
  }
  return image;
}

}  // namespace

DepthImage depth_image(const PointsView& cloud, std::span<const std::uint16_t> labels,
                       ImageSize projected) {
  if (!cloud.organised()) return project(cloud, labels, projected);
  DepthImage image = blank(cloud.width, cloud.height);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!recording::is_measured(cloud.point(i))) continue;
    image.depth_m[i] = cloud.point(i)[2];
    image.label[i] = labels[i];
  }
  return image;
}

ImageSize filled_size(std::size_t points) {
  constexpr double columns_a_row = 4.0 / 3;
  const double rows = std::sqrt(static_cast<double>(points) / 2 / columns_a_row);
  const auto whole = [](double value) { return static_cast<std::uint32_t>(std::ceil(value)); };
  return {std::max(1U, whole(rows * columns_a_row)), std::max(1U, whole(rows))};
}

}  // namespace cleave
