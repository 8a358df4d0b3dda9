// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/depth_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sensor/renderer/noise_field.hpp"
#include "sensor/renderer/view/visible_parts.hpp"

namespace cleave::render {
namespace {

constexpr double millimetres = 1000;
constexpr double largest_depth_mm = 10000;  // what such a camera's driver announces

// The camera correlates windows of about this size: 2 radius + 1.
constexpr std::int64_t window_radius_px = 2;

struct Neighbourhood {
  float mean_disparity;
  float edge_share;
};

Neighbourhood correlate_window(const RayCast& rays, std::uint32_t x, std::uint32_t y) {
  const float centre_m = rays.depth_m[std::size_t{y} * rays.width + x];
  double sum = 0;
  int same_side = 0;
  int other_side = 0;
  for (std::int64_t dy = -window_radius_px; dy <= window_radius_px; ++dy) {
    for (std::int64_t dx = -window_radius_px; dx <= window_radius_px; ++dx) {
      const std::int64_t column = x + dx;
      const std::int64_t row = y + dy;
      if (column < 0 || row < 0 || column >= rays.width || row >= rays.height) continue;
      const float depth_m = rays.depth_m[static_cast<std::size_t>(row * rays.width + column)];
      if (!std::isfinite(depth_m)) continue;
      const float slope_m = 0.002F * static_cast<float>(std::abs(dx) + std::abs(dy));
      if (std::abs(depth_m - centre_m) > 0.015F * centre_m + slope_m) {
        ++other_side;
      } else {
        sum += disparity_metres / depth_m;
        ++same_side;
      }
    }
  }
  return {static_cast<float>(sum / same_side),
          static_cast<float>(other_side) / static_cast<float>(same_side + other_side)};
}

// One frame's noise. Radii are those of noise_field(); disparities in steps of 1.
struct FrameNoise {
  std::vector<float> low, middle, fine, white;  // of the disparity
  std::vector<float> shift_x, shift_y;          // of edges
  std::vector<float> loss, holes;               // of pixels

  FrameNoise(std::uint64_t seed, std::uint32_t width, std::uint32_t height) {
    Random random(seed);
    const auto field = [&](std::uint32_t radius) {
      const std::uint32_t largest = (std::min(width, height) - 1) / 2;
      return noise_field(random, width, height, std::min(radius, largest));
    };
    low = field(45);
    middle = field(2);
    fine = field(1);
    white = field(0);
    shift_x = field(2);
    shift_y = field(2);
    loss = field(1);
    holes = field(3);
  }

  float disparity(std::size_t i) const {
    return 0.63F * low[i] + 0.57F * middle[i] + 0.20F * fine[i] + 0.15F * white[i];
  }

  // The pixel whose rays the camera takes for pixel (x, y) near an edge.
  std::size_t looked_up(std::int64_t x, std::int64_t y, std::int64_t width,
                        std::int64_t height) const {
    constexpr float shift_px = 0.7F;
    const auto i = static_cast<std::size_t>(y * width + x);
    const std::int64_t column = x + std::lround(shift_px * shift_x[i]);
    const std::int64_t row = y + std::lround(shift_px * shift_y[i]);
    return static_cast<std::size_t>(std::clamp<std::int64_t>(row, 0, height - 1) * width +
                                    std::clamp<std::int64_t>(column, 0, width - 1));
  }

  bool loses(std::size_t i, float cosine, float edge_share) const {
    if (cosine < 0.15F + 0.05F * loss[i]) return true;
    if (edge_share > 0.25F && loss[i] < -1 + 1.4F * (edge_share - 0.25F)) return true;
    return holes[i] < -3.6F;
  }
};

std::uint16_t quantised_mm(float disparity) {
  if (disparity < disparity_metres * millimetres / largest_depth_mm) return 0;
  const double steps = std::floor(disparity + 0.5);
  return static_cast<std::uint16_t>(std::lround(disparity_metres * millimetres / steps));
}

}  // namespace

DepthSensor::DepthSensor(const RayCast& rays)
    : width_(rays.width), height_(rays.height), pixels_(rays.depth_m.size()) {
  const std::vector<std::uint16_t> labels = label_visible_parts(rays);
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < height_; ++y) {
    for (std::uint32_t x = 0; x < width_; ++x, ++i) {
      Pixel& pixel = pixels_[i];
      pixel = {rays.depth_m[i], 0, 0, rays.cosine[i], rays.surface[i], labels[i]};
      if (pixel.label == 0) continue;
      const Neighbourhood around = correlate_window(rays, x, y);
      pixel.disparity = around.mean_disparity;
      pixel.edge_share = around.edge_share;
    }
  }
}

LabelledDepth DepthSensor::measure(std::uint64_t noise_seed) const {
  const FrameNoise noise(noise_seed, width_, height_);
  LabelledDepth image{width_, height_, std::vector<std::uint16_t>(pixels_.size()),
                      std::vector<std::uint16_t>(pixels_.size())};
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < height_; ++y) {
    for (std::uint32_t x = 0; x < width_; ++x, ++i) {
      const Pixel& shifted = pixels_[noise.looked_up(x, y, width_, height_)];
      const Pixel& own = pixels_[i];
      // Only edges are displaced: within a surface the shift would be noise of its own.
      const bool within_surface = own.label != 0 && own.surface == shifted.surface &&
                                  std::abs(own.depth_m - shifted.depth_m) < 0.02F;
      const Pixel& seen = within_surface ? own : shifted;
      if (seen.label == 0 || noise.loses(i, seen.cosine, seen.edge_share)) continue;
      image.depth_mm[i] = quantised_mm(seen.disparity + noise.disparity(i));
      if (image.depth_mm[i] != 0) image.label[i] = seen.label;
    }
  }
  return image;
}

LabelledDepth DepthSensor::measure_without_noise() const {
  LabelledDepth image{width_, height_, std::vector<std::uint16_t>(pixels_.size()),
                      std::vector<std::uint16_t>(pixels_.size())};
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const double depth_mm = pixels_[i].depth_m * millimetres;
    if (pixels_[i].label == 0 || depth_mm > largest_depth_mm) continue;
    image.depth_mm[i] = static_cast<std::uint16_t>(std::lround(depth_mm));
    image.label[i] = pixels_[i].label;
  }
  return image;
}

}  // namespace cleave::render
