// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/depth_to_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "recording/frames/frame.hpp"

namespace cleave::recording {
namespace {

constexpr Intrinsics camera{525.0F, 520.0F, 319.5F, 239.5F};

// The pinhole model pixel by pixel, in double.
void expect_pinhole(const DepthRows& image, const std::vector<float>& xyz) {
  for (std::uint32_t v = 0; v < image.height; ++v) {
    for (std::uint32_t u = 0; u < image.width; ++u) {
      const float* const p = xyz.data() + 3 * (std::size_t{v} * image.width + u);
      const std::uint16_t depth = image.depth[v * image.stride_bytes / 2 + u];
      if (depth == 0) {
        ASSERT_TRUE(std::isnan(p[0]) && std::isnan(p[1]) && std::isnan(p[2])) << u << ", " << v;
        continue;
      }
      const double z = depth * static_cast<double>(image.unit_m);
      ASSERT_NEAR(p[0], (u - 319.5) * z / 525.0, 1e-6 * z);
      ASSERT_NEAR(p[1], (v - 239.5) * z / 520.0, 1e-6 * z);
      ASSERT_NEAR(p[2], z, 1e-6 * z);
    }
  }
}

std::vector<std::uint16_t> random_depth(std::size_t size) {
  std::mt19937 random(7);
  std::vector<std::uint16_t> depth(size);
  for (auto& d : depth) d = random() % 4 == 0 ? 0 : static_cast<std::uint16_t>(random());
  return depth;
}

TEST(DepthProjection, AgreesWithThePinholeModelInMillimetres) {
  const auto depth = random_depth(capacity_points);
  const DepthRows image{depth.data(), 640, 480, 1280, 1e-3F};
  std::vector<float> xyz(3 * capacity_points);
  DepthProjection(640, 480, camera).write_points(image, xyz.data());
  expect_pinhole(image, xyz);
}

TEST(DepthProjection, AgreesWithThePinholeModelInTenthsOfMillimetresAndPaddedRows) {
  const auto depth = random_depth(4800);
  const DepthRows image{depth.data(), 64, 48, 200, 1e-4F};
  std::vector<float> xyz(9216);
  DepthProjection(64, 48, camera).write_points(image, xyz.data());
  expect_pinhole(image, xyz);
}

TEST(IntrinsicsFromFov, AreThoseOfAPrimeSenseCamera) {
  const auto fov = [](double size) { return static_cast<float>(2 * std::atan(size / 2 / 525)); };
  const Intrinsics found = intrinsics_from_fov(640, 480, fov(640), fov(480));
  EXPECT_NEAR(found.fx, 525, 1e-3);
  EXPECT_NEAR(found.fy, 525, 1e-3);
  EXPECT_EQ(found.cx, 319.5F);
  EXPECT_EQ(found.cy, 239.5F);
}

TEST(IntrinsicsFromFov, AreNoneWithoutAFieldOfView) {
  EXPECT_EQ(intrinsics_from_fov(640, 480, 0, 0.8F).fx, 0);
  EXPECT_EQ(intrinsics_from_fov(640, 480, 4, 0.8F).fx, 0);
  EXPECT_EQ(intrinsics_from_fov(640, 480, NAN, 0.8F).fx, 0);
}

}  // namespace
}  // namespace cleave::recording
