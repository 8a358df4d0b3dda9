// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/depth_codec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "recording/error.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

std::vector<float> decoded(const DepthImage& image, const Cloud& cloud) {
  std::vector<float> xyz(cloud.xyz.size());
  decode(image, cloud.header.width, cloud.header.height, xyz.data());
  return xyz;
}

// The same camera's points by another computation.
Cloud recomputed(const std::function<float(double pixels, float z, double depth_mm)>& coordinate) {
  Cloud cloud = depth_cloud(1);
  const FrameHeader& h = cloud.header;
  float* p = cloud.xyz.data();
  for (std::uint32_t v = 0; v < h.height; ++v) {
    for (std::uint32_t u = 0; u < h.width; ++u, p += 3) {
      const double mm = std::round(static_cast<double>(p[2]) * 1000);
      p[0] = coordinate(u - double{h.cx}, p[2], mm);
      p[1] = coordinate(v - double{h.cy}, p[2], mm);
    }
  }
  return cloud;
}

TEST(DepthCodec, GivesTheGrabbersPointsBackWithoutACorrection) {
  const Cloud cloud = depth_cloud(1);
  const auto image = DepthEncoder().encode(cloud);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->projection, Projection::ray);
  EXPECT_TRUE(image->correction.empty());
  EXPECT_TRUE(same_points(decoded(*image, cloud), cloud.xyz));
}

TEST(DepthCodec, GivesPclsPointsBackWithoutACorrection) {
  const Cloud cloud = recomputed([](double pixels, float z, double /*mm*/) {
    return (static_cast<float>(pixels) * z) * (1 / 52.5F);
  });
  const auto image = DepthEncoder().encode(cloud);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->projection, Projection::point);
  EXPECT_TRUE(image->correction.empty());
  EXPECT_TRUE(same_points(decoded(*image, cloud), cloud.xyz));
}

TEST(DepthCodec, GivesPointsBackBitForBitThatNoProjectionExplains) {
  const Cloud cloud = recomputed([](double pixels, float z, double /*mm*/) {
    return std::nextafter(static_cast<float>(pixels / 52.5) * z, 1.0F);
  });
  const auto image = DepthEncoder().encode(cloud);
  ASSERT_TRUE(image);
  EXPECT_FALSE(image->correction.empty());
  EXPECT_TRUE(same_points(decoded(*image, cloud), cloud.xyz));
}

TEST(DepthCodec, FindsTheSameWithIntrinsicsThatWereFitted) {
  Cloud cloud = depth_cloud(1);
  cloud.header.fx = 52.50001F;
  const auto image = DepthEncoder().encode(cloud);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->intrinsics.fx, 52.5F);
  EXPECT_TRUE(same_points(decoded(*image, cloud), cloud.xyz));
}

TEST(DepthCodec, RefusesWhatDepthCannotGiveBackTo1Micrometre) {
  DepthEncoder encoder;
  EXPECT_FALSE(encoder.encode(free_cloud(1)));
  Cloud off = depth_cloud(1);
  off.xyz[3] += 2e-6F;
  EXPECT_FALSE(encoder.encode(off));
  Cloud off_grid = depth_cloud(1);
  for (std::size_t i = 2; i < off_grid.xyz.size(); i += 3) off_grid.xyz[i] += 0.0004F;
  EXPECT_FALSE(encoder.encode(off_grid));
  Cloud no_camera = depth_cloud(1);
  no_camera.header.fx = 0;
  EXPECT_FALSE(encoder.encode(no_camera));
}

TEST(DepthCodec, RefusesPointsOfWhichOnlyAPartIsFinite) {
  Cloud cloud = depth_cloud(1);
  cloud.xyz[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(DepthEncoder().encode(cloud));
}

TEST(DepthCodec, RefusesPointsBehindTheCameraAndBeyondItsDepth) {
  Cloud behind = depth_cloud(1);
  for (float& coordinate : behind.xyz) coordinate = -coordinate;
  EXPECT_FALSE(DepthEncoder().encode(behind));
  Cloud far = depth_cloud(1);
  for (float& coordinate : far.xyz) coordinate *= 100;
  EXPECT_FALSE(DepthEncoder().encode(far));
}

TEST(DepthCodec, RefusesPartsThatDisagree) {
  const Cloud cloud = depth_cloud(1);
  DepthImage image = DepthEncoder().encode(cloud).value();
  image.correction.resize(5);
  EXPECT_THROW((void)decoded(image, cloud), DataError);
  image.correction.clear();
  image.projection = Projection{17};
  EXPECT_THROW((void)decoded(image, cloud), DataError);
  image.projection = Projection::ray;
  image.depth_mm.pop_back();
  EXPECT_THROW((void)decoded(image, cloud), DataError);
}

}  // namespace
}  // namespace cleave::recording
