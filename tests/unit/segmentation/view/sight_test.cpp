// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/sight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/unit/segmentation/support/depth_scene.hpp"

namespace cleave::segmentation {
namespace {

TEST(SightedPoints, HaveTheirMiddleWhereverAStrayIs) {
  DepthScene scene(1);
  SightedPoints points;
  points.take(scene.view());
  const Eigen::Vector3d middle = points.middle();
  const double extent_m = points.extent_m();
  std::fill_n(scene.xyz.data() + 3 * 160 * 60, 3, 1e30F);

  points.take(scene.view());

  EXPECT_LT((points.middle() - middle).norm(), 0.01);
  EXPECT_NEAR(points.extent_m(), extent_m, 0.01);
}

TEST(SightedPoints, ForgetTheLastCloudWhereNothingIsMeasured) {
  const DepthScene scene(1);
  const std::vector<float> nothing(30, std::numeric_limits<float>::quiet_NaN());
  SightedPoints points;
  points.take(scene.view());

  points.take({nothing.data(), 3, 10, 1});

  EXPECT_EQ(points.size(), 0U);
  EXPECT_TRUE(points.middle().isZero(0));
  EXPECT_EQ(points.extent_m(), 0);
}

TEST(SightedPoints, HideOthersFromWhereTheyStandInFrontOfThem) {
  // A wall at 2 m, and before its left half another at 1 m, as dense.
  std::vector<float> xyz;
  for (int i = 0; i < 100 * 100; ++i) {
    const float x = 0.01F * static_cast<float>(i % 100 - 50);
    const float y = 0.01F * static_cast<float>(i / 100 - 50);
    xyz.insert(xyz.end(), {2 * x, 2 * y, 2});
    if (x < 0) xyz.insert(xyz.end(), {x, y, 1});
  }
  SightedPoints points;
  points.take({xyz.data(), 3, static_cast<std::uint32_t>(xyz.size() / 3), 1});

  EXPECT_NEAR(points.share_hidden(Eigen::Vector3d::Zero(), 0.01), 1.0 / 3, 0.03);
  EXPECT_EQ(points.share_hidden({0, -100, 1.5}, 0.0001), 0);
}

}  // namespace
}  // namespace cleave::segmentation
