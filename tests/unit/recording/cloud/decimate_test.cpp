// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/decimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace cleave::recording {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::vector<float> image_of(const std::vector<float>& depth, std::uint32_t width,
                            const Intrinsics& i) {
  std::vector<float> xyz;
  for (std::size_t p = 0; p < depth.size(); ++p) {
    const auto u = static_cast<float>(p % width);
    const auto v = static_cast<float>(p / width);
    const float z = depth[p];
    xyz.insert(xyz.end(), {(u - i.cx) / i.fx * z, (v - i.cy) / i.fy * z, z});
  }
  return xyz;
}

const Intrinsics small_camera = {100, 100, 1.5F, .5F};

TEST(Decimation, TakesTheMedianDepthOfABlockOntoTheRayThroughItsMiddle) {
  const std::vector<float> xyz = image_of({1, 2, 5, 5, 3, 9, 5, 5}, 4, small_camera);
  Decimator decimator(2);
  std::vector<float> smaller(6);
  decimator.decimate(xyz.data(), 4, 2, small_camera, smaller.data());
  EXPECT_FLOAT_EQ(smaller[2], 2);  // of 1 2 3 9 the lower one in the middle
  // The middle of the block is at (.5, .5): one pixel left of the principal point, on its row.
  EXPECT_FLOAT_EQ(smaller[0], -1.F / 100 * 2);
  EXPECT_FLOAT_EQ(smaller[1], 0);
  EXPECT_FLOAT_EQ(smaller[5], 5);
  EXPECT_FLOAT_EQ(smaller[3], 1.F / 100 * 5);
}

TEST(Decimation, LeavesABlockWithoutMeasurementWithoutOneAndPassesOverHoles) {
  const std::vector<float> xyz = image_of({nan, nan, nan, 4, nan, nan, nan, nan}, 4, small_camera);
  Decimator decimator(2);
  std::vector<float> smaller(6);
  decimator.decimate(xyz.data(), 4, 2, small_camera, smaller.data());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(smaller[static_cast<std::size_t>(i)]));
  EXPECT_FLOAT_EQ(smaller[5], 4);
}

TEST(Decimation, KeepsMeasuredPointsWhereNoIntrinsicsAreKnown) {
  const std::vector<float> xyz = {0, 0, 3, 1, 0, 2, 0, 1, 4, 1, 1, 9};
  Decimator decimator(2);
  std::vector<float> smaller(3);
  decimator.decimate(xyz.data(), 2, 2, {}, smaller.data());
  EXPECT_EQ(smaller, (std::vector<float>{0, 0, 3}));
}

TEST(Decimation, LeavesOutColumnsAndRowsThatFillNoWholeBlock) {
  const Decimator decimator(3);
  EXPECT_EQ(decimator.width(848), 282U);
  EXPECT_EQ(decimator.height(480), 160U);
}

TEST(Decimation, OfIntrinsicsLooksAlongTheSameRays) {
  const Intrinsics smaller = Decimator(2).intrinsics({600, 500, 319.5F, 239.5F});
  EXPECT_EQ(smaller, (Intrinsics{300, 250, 159.5F, 119.5F}));
  EXPECT_EQ(Decimator(2).intrinsics({}), Intrinsics{});
}

}  // namespace
}  // namespace cleave::recording
