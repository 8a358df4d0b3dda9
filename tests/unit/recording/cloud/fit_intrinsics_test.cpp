// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/fit_intrinsics.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace cleave::recording {
namespace {

constexpr std::uint32_t width = 64, height = 48;
constexpr Intrinsics truth{52.5F, 50.0F, 31.5F, 23.0F};

// An organised cloud of this camera, a fifth of its points missing.
std::vector<float> cloud() {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> depth(0.5F, 2.0F);
  std::vector<float> xyz;
  for (std::uint32_t v = 0; v < height; ++v) {
    for (std::uint32_t u = 0; u < width; ++u) {
      const float z = random() % 5 == 0 ? std::numeric_limits<float>::quiet_NaN() : depth(random);
      xyz.push_back((static_cast<float>(u) - truth.cx) / truth.fx * z);
      xyz.push_back((static_cast<float>(v) - truth.cy) / truth.fy * z);
      xyz.push_back(z);
    }
  }
  return xyz;
}

TEST(FitIntrinsics, FindsTheCameraOfAnOrganisedCloud) {
  const Intrinsics found = fit_intrinsics(cloud().data(), width, height);
  EXPECT_NEAR(found.fx, truth.fx, 1e-3);
  EXPECT_NEAR(found.fy, truth.fy, 1e-3);
  EXPECT_NEAR(found.cx, truth.cx, 1e-3);
  EXPECT_NEAR(found.cy, truth.cy, 1e-3);
}

TEST(FitIntrinsics, FindsNoneWhenOnePointIsOff) {
  std::vector<float> xyz = cloud();
  xyz[0] = 0.3F;
  xyz[1] = 0.2F;
  xyz[2] = 1.0F;
  EXPECT_EQ(fit_intrinsics(xyz.data(), width, height).fx, 0);
}

TEST(FitIntrinsics, FindsNoneForAnUnorganisedCloud) {
  EXPECT_EQ(fit_intrinsics(cloud().data(), width * height, 1).fx, 0);
}

TEST(FitIntrinsics, FindsNoneForATransformedCloud) {
  std::vector<float> xyz = cloud();
  for (std::size_t i = 2; i < xyz.size(); i += 3) xyz[i] += 1;
  EXPECT_EQ(fit_intrinsics(xyz.data(), width, height).fx, 0);
}

TEST(FitIntrinsics, FindsNoneForPointsBehindTheCamera) {
  std::vector<float> xyz = cloud();
  for (float& coordinate : xyz) coordinate = -coordinate;
  EXPECT_EQ(fit_intrinsics(xyz.data(), width, height).fx, 0);
}

TEST(FitIntrinsics, FindsNoneWhereNothingIsMeasured) {
  const std::vector<float> xyz(std::size_t{3} * width * height,
                               std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(fit_intrinsics(xyz.data(), width, height).fx, 0);
}

TEST(FitIntrinsics, FindsNoneFromASingleColumn) {
  std::vector<float> xyz = cloud();
  for (std::size_t i = 0; i < xyz.size() / 3; ++i) {
    if (i % width != 5) xyz[3 * i] = xyz[3 * i + 1] = xyz[3 * i + 2] = NAN;
  }
  EXPECT_EQ(fit_intrinsics(xyz.data(), width, height).fx, 0);
}

}  // namespace
}  // namespace cleave::recording
