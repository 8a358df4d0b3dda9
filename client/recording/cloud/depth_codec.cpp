// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/depth_codec.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "recording/error.hpp"

namespace cleave::recording {
namespace {

constexpr float tolerance_m = 1e-6F;
// A projection that leaves so few points to be corrected is good enough: the others are not tried.
constexpr std::size_t good_enough_share = 100;  // one in so many

bool is_measurement(const float* p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

bool is_nothing(const float* p) {
  return std::isnan(p[0]) && std::isnan(p[1]) && std::isnan(p[2]);
}

// Empty where a point has no depth in whole millimetres.
std::vector<std::uint16_t> depth_of(const Cloud& cloud) {
  std::vector<std::uint16_t> depth(cloud.xyz.size() / 3);
  const float* p = cloud.xyz.data();
  for (std::uint16_t& mm : depth) {
    if (is_measurement(p)) {
      const float rounded = std::nearbyint(p[2] * 1000);
      if (!(rounded >= 1 && rounded <= 65535)) return {};
      mm = static_cast<std::uint16_t>(rounded);
      if (std::fabs(static_cast<double>(p[2]) - mm * 0.001) >
          2 * static_cast<double>(tolerance_m)) {
        return {};
      }
    } else if (!is_nothing(p)) {
      return {};
    }
    p += 3;
  }
  return depth;
}

// What must be added to the bits of `from` to get those of `to`.
std::int64_t bits_between(float from, float to) {
  return std::int64_t{std::bit_cast<std::int32_t>(to)} - std::bit_cast<std::int32_t>(from);
}

constexpr std::size_t useless = ~std::size_t{0};

// Fills in what turns `points` into `wanted`; the number of coordinates that differ, or `useless`
// where one is too far off.
std::size_t correct(std::span<const float> points, std::span<const float> wanted,
                    std::vector<std::uint8_t>& correction) {
  correction.assign(wanted.size(), 0);
  const std::size_t plane = wanted.size() / 3;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (points[i] == wanted[i] ? std::signbit(points[i]) == std::signbit(wanted[i])
                               : std::isnan(wanted[i])) {
      continue;
    }
    const std::int64_t bits = bits_between(points[i], wanted[i]);
    if (std::fabs(points[i] - wanted[i]) > tolerance_m || bits < -128 || bits > 127) return useless;
    correction[(i % 3) * plane + i / 3] = static_cast<std::uint8_t>(bits);
    ++differ;
  }
  return differ;
}

// Most of it is 0.
void apply_correction(std::span<const std::uint8_t> correction, float* xyz) {
  const std::size_t points = correction.size() / 3;
  const auto is_set = [](std::uint8_t bits) { return bits != 0; };
  auto at = correction.begin();
  while ((at = std::find_if(at, correction.end(), is_set)) != correction.end()) {
    const auto i = static_cast<std::size_t>(at - correction.begin());
    float& coordinate = xyz[3 * (i % points) + i / points];
    // Unsigned, for a damaged file may ask for any sum.
    const std::int32_t bits = *at < 128 ? *at : *at - 256;
    coordinate = std::bit_cast<float>(std::bit_cast<std::uint32_t>(coordinate) +
                                      static_cast<std::uint32_t>(bits));
    ++at;
  }
}

float to_half_pixel(float x) {
  return std::nearbyint(2 * x) / 2;
}

}  // namespace

// Intrinsics that were fitted to the points are off in the last digits; sensors have whole or half
// pixels.
std::vector<DepthEncoder::Candidate> DepthEncoder::candidates(const FrameHeader& h) const {
  const Intrinsics exact{h.fx, h.fy, h.cx, h.cy};
  const Intrinsics rounded{to_half_pixel(h.fx), to_half_pixel(h.fy), to_half_pixel(h.cx),
                           to_half_pixel(h.cy)};
  std::vector<Candidate> result;
  if (last_ && (last_->intrinsics == exact || last_->intrinsics == rounded)) {
    result.push_back(*last_);
  }
  for (const Projection projection : {Projection::ray, Projection::point, Projection::precise,
                                      Projection::point_text, Projection::precise_text}) {
    result.push_back({exact, projection});
    if (rounded != exact && rounded.fx > 0 && rounded.fy > 0) {
      result.push_back({rounded, projection});
    }
  }
  return result;
}

std::optional<DepthImage> DepthEncoder::encode(const Cloud& cloud) {
  const FrameHeader& header = cloud.header;
  if (header.height < 2 || !(header.fx > 0) || !(header.fy > 0)) return std::nullopt;
  DepthImage image;
  image.depth_mm = depth_of(cloud);
  if (image.depth_mm.empty()) return std::nullopt;

  points_.resize(cloud.xyz.size());
  std::size_t fewest = useless;
  for (const Candidate& candidate : candidates(header)) {
    project({image.depth_mm, header.width, header.height}, candidate.intrinsics,
            candidate.projection, points_.data());
    const std::size_t differ = correct(points_, cloud.xyz, correction_);
    if (differ >= fewest) continue;
    fewest = differ;
    last_ = candidate;
    image.intrinsics = candidate.intrinsics;
    image.projection = candidate.projection;
    std::swap(image.correction, correction_);
    if (fewest <= cloud.xyz.size() / good_enough_share) break;
  }
  if (fewest == useless) return std::nullopt;
  if (fewest == 0) image.correction.clear();
  return image;
}

void decode(const DepthImage& image, std::uint32_t width, std::uint32_t height, float* xyz) {
  const std::size_t points = std::size_t{width} * height;
  if (image.depth_mm.size() != points) throw DataError("a depth image is not of its cloud's size");
  if (image.projection < Projection::ray || image.projection > Projection::precise_text) {
    throw DataError("a depth image is of a projection that this version does not know");
  }
  project({image.depth_mm, width, height}, image.intrinsics, image.projection, xyz);
  if (image.correction.empty()) return;
  if (image.correction.size() != 3 * points) {
    throw DataError("a cloud's correction is not of its size");
  }
  apply_correction(image.correction, xyz);
}

}  // namespace cleave::recording
