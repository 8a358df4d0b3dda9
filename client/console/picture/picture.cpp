// SPDX-License-Identifier: BSD-3-Clause
#include "console/picture/picture.hpp"

#include <algorithm>
#include <cmath>

namespace cleave {
namespace {

// Hue in turns, saturation and value from 0 to 1.
Rgb from_hsv(double hue, double saturation, double value) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hue * 6, 6.0);
    const double share = value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
    return static_cast<std::uint8_t>(std::lround(255 * share));
  };
  return {channel(5), channel(3), channel(1)};
}

// From 1 for the nearest to `darkest` for the furthest pixel; 0 = no measurement. The ends are
// percentiles: a stray pixel does not decide the contrast of all the others.
std::vector<float> brightness(const DepthImage& image) {
  constexpr float darkest = 0.25F;
  std::vector<float> depths;
  for (const float depth_m : image.depth_m) {
    if (std::isfinite(depth_m)) depths.push_back(depth_m);
  }
  std::vector<float> result(image.depth_m.size(), 0);
  if (depths.empty()) return result;
  std::sort(depths.begin(), depths.end());
  const float near_m = depths[depths.size() / 100];
  const float far_m = depths[depths.size() - 1 - depths.size() / 100];
  const float span_m = std::max(far_m - near_m, 1e-6F);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!std::isfinite(image.depth_m[i])) continue;
    const float share = std::clamp((image.depth_m[i] - near_m) / span_m, 0.0F, 1.0F);
    result[i] = 1 - (1 - darkest) * share;
  }
  return result;
}

std::uint8_t scaled(float channel) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0F, 255.0F)));
}

Rgb grey(float brightness) {
  const std::uint8_t level = scaled(255 * brightness);
  return {level, level, level};
}

Rgb tinted(Rgb colour, float brightness, bool border) {
  const float strength = (border ? 0.5F : 1.0F) * (0.35F + 0.65F * brightness);
  return {scaled(strength * static_cast<float>(colour.red)),
          scaled(strength * static_cast<float>(colour.green)),
          scaled(strength * static_cast<float>(colour.blue))};
}

// Whether the pixel's label ends here: another one to the right or below.
bool on_border(const DepthImage& image, std::uint32_t column, std::uint32_t row) {
  const std::size_t i = std::size_t{row} * image.width + column;
  const bool right = column + 1 < image.width && image.label[i + 1] != image.label[i];
  const bool below = row + 1 < image.height && image.label[i + image.width] != image.label[i];
  return right || below;
}

}  // namespace

Rgb label_colour(std::uint16_t label) {
  constexpr double golden_ratio_conjugate = 0.6180339887498949;
  const double turns = label * golden_ratio_conjugate;
  const double saturation = label % 2 == 0 ? 0.55 : 0.85;
  return from_hsv(turns - std::floor(turns), saturation, 1.0);
}

Picture depth_picture(const DepthImage& image) {
  Picture picture{image.width, image.height, {}};
  picture.pixels.reserve(image.depth_m.size());
  for (const float level : brightness(image)) picture.pixels.push_back(grey(level));
  return picture;
}

Picture segment_picture(const DepthImage& image) {
  const std::vector<float> levels = brightness(image);
  Picture picture{image.width, image.height, {}};
  picture.pixels.reserve(levels.size());
  for (std::uint32_t row = 0; row < image.height; ++row) {
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const std::size_t i = picture.pixels.size();
      const std::uint16_t label = image.label[i];
      picture.pixels.push_back(
          label == 0 ? grey(levels[i])
                     : tinted(label_colour(label), levels[i], on_border(image, column, row)));
    }
  }
  return picture;
}

Picture difference_picture(const DepthImage& truth, std::span<const std::uint16_t> found) {
  constexpr Rgb right{80, 220, 80};
  constexpr Rgb wrong{255, 40, 40};
  const std::vector<float> levels = brightness(truth);
  Picture picture{truth.width, truth.height, {}};
  picture.pixels.reserve(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    picture.pixels.push_back(
        truth.label[i] == 0 ? grey(levels[i])
                            : tinted(truth.label[i] == found[i] ? right : wrong, levels[i], false));
  }
  return picture;
}

Picture side_by_side(const Picture& left, const Picture& right) {
  Picture both{left.width + right.width, left.height, {}};
  both.pixels.reserve(std::size_t{both.width} * both.height);
  for (std::uint32_t row = 0; row < both.height; ++row) {
    for (const Picture* half : {&left, &right}) {
      const auto begin = half->pixels.begin() + static_cast<std::ptrdiff_t>(row) * half->width;
      both.pixels.insert(both.pixels.end(), begin, begin + half->width);
    }
  }
  return both;
}

Picture one_above_other(const Picture& top, const Picture& bottom) {
  Picture both{top.width, top.height + bottom.height, top.pixels};
  both.pixels.insert(both.pixels.end(), bottom.pixels.begin(), bottom.pixels.end());
  return both;
}

}  // namespace cleave
