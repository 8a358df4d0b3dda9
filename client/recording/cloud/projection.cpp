// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/projection.hpp"

#include <limits>

#include "recording/cloud/decimal_digits.hpp"
#include "recording/cloud/depth_to_points.hpp"
#include "recording/cloud/measured.hpp"

namespace cleave::recording {
namespace {

constexpr float metres_per_mm = 0.001F;

// i - principal point, in pixels.
std::vector<float> offsets(std::uint32_t count, float principal_point) {
  std::vector<float> result(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    result[i] = static_cast<float>(static_cast<double>(i) - static_cast<double>(principal_point));
  }
  return result;
}

// Calls point(column, row, depth in mm, out) for every pixel with a measurement.
template <class Point>
void for_each_pixel(const DepthView& image, float* xyz, const Point& point) {
  std::size_t i = 0;
  for (std::uint32_t v = 0; v < image.height; ++v) {
    for (std::uint32_t u = 0; u < image.width; ++u, ++i, xyz += 3) {
      if (image.depth_mm[i] == 0) {
        xyz[0] = xyz[1] = xyz[2] = no_measurement;
      } else {
        point(u, v, image.depth_mm[i], xyz);
      }
    }
  }
}

void project_rays(const DepthView& image, const Intrinsics& k, float* xyz) {
  DepthProjection(image.width, image.height, k)
      .write_points({image.depth_mm.data(), image.width, image.height,
                     std::size_t{image.width} * sizeof(std::uint16_t), metres_per_mm},
                    xyz);
}

// Neighbours often have the same depth: what follows from it is kept.
class LastDepth {
 public:
  template <class Compute>
  float operator()(std::uint16_t depth_mm, const Compute& compute) {
    if (depth_mm != depth_mm_) {
      depth_mm_ = depth_mm;
      value_ = compute(depth_mm);
    }
    return value_;
  }

 private:
  std::uint16_t depth_mm_ = 0;
  float value_ = 0;
};

template <class Round>
void project_points(const DepthView& image, const Intrinsics& k, float* xyz, const Round& round) {
  const std::vector<float> column = offsets(image.width, k.cx);
  const std::vector<float> row = offsets(image.height, k.cy);
  const float per_fx = 1 / k.fx;
  const float per_fy = 1 / k.fy;
  LastDepth rounded;
  for_each_pixel(image, xyz, [&](auto u, auto v, std::uint16_t depth_mm, float* out) {
    const float z = depth_mm * metres_per_mm;
    out[0] = round((column[u] * z) * per_fx);
    out[1] = round((row[v] * z) * per_fy);
    out[2] = rounded(depth_mm, [&](std::uint16_t mm) { return round(mm * metres_per_mm); });
  });
}

template <class Round>
void project_precisely(const DepthView& image, const Intrinsics& k, float* xyz,
                       const Round& round) {
  const auto slope = [](std::uint32_t i, float centre, float focal_length) {
    return (i - double{centre}) / double{focal_length};
  };
  LastDepth rounded;
  for_each_pixel(image, xyz, [&](auto u, auto v, std::uint16_t depth_mm, float* out) {
    const double z = depth_mm * 0.001;
    out[0] = round(slope(u, k.cx, k.fx) * z);
    out[1] = round(slope(v, k.cy, k.fy) * z);
    out[2] = rounded(depth_mm, [&](std::uint16_t mm) { return round(mm * 0.001); });
  });
}

float as_it_is(double x) {
  return static_cast<float>(x);
}

}  // namespace

void project(const DepthView& image, const Intrinsics& intrinsics, Projection projection,
             float* xyz) {
  switch (projection) {
    case Projection::none:
      return;
    case Projection::ray:
      return project_rays(image, intrinsics, xyz);
    case Projection::point:
      return project_points(image, intrinsics, xyz, as_it_is);
    case Projection::point_text:
      return project_points(image, intrinsics, xyz, round_to_7_digits);
    case Projection::precise:
      return project_precisely(image, intrinsics, xyz, as_it_is);
    case Projection::precise_text:
      return project_precisely(image, intrinsics, xyz, round_to_7_digits);
  }
}

}  // namespace cleave::recording
