// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/describe/oriented_box.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace cleave::segmentation {
namespace {

OrientedBox box_around(const std::vector<Surfel>& surface) {
  const Eigen::Matrix3f axes = box_axes(surface, std::array{dominant_normal(surface)});
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Vector3f high = -low;
  for (const Surfel& s : surface) {
    low = low.cwiseMin(axes.transpose() * s.position);
    high = high.cwiseMax(axes.transpose() * s.position);
  }
  return make_box(axes, low, high);
}

// The top and one side of a box of 0.3 x 0.2 x 0.1 m, turned in space.
std::vector<Surfel> two_faces(const Eigen::Quaternionf& turn, const Eigen::Vector3f& centre) {
  std::vector<Surfel> surface;
  for (int i = 0; i <= 30; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const float x = 0.01F * static_cast<float>(i) - 0.15F;
      const float y = 0.01F * static_cast<float>(j) - 0.1F;
      surface.push_back(
          {turn * Eigen::Vector3f(x, y, 0.05F) + centre, turn * Eigen::Vector3f::UnitZ()});
      if (j <= 10) {
        surface.push_back({turn * Eigen::Vector3f(x, -0.1F, y + 0.05F) + centre,
                           turn * -Eigen::Vector3f::UnitY()});
      }
    }
  }
  return surface;
}

TEST(OrientedBox, FitsABoxOfWhichTwoFacesAreSeen) {
  const Eigen::Vector3f centre(0.3F, -0.2F, 1);
  for (const float angle_rad : {0.0F, 0.4F, 1.1F}) {
    const Eigen::Quaternionf turn(
        Eigen::AngleAxisf(angle_rad, Eigen::Vector3f(1, 2, 3).normalized()));

    const OrientedBox box = box_around(two_faces(turn, centre));

    // In steps of five degrees a side can be too long by sin(2.5 deg) of the other.
    EXPECT_NEAR(box.extent[0], 0.3F, 0.012F);
    EXPECT_NEAR(box.extent[1], 0.2F, 0.015F);
    EXPECT_NEAR(box.extent[2], 0.1F, 0.002F);
    EXPECT_LT((box.centre - centre).norm(), 0.002F);
  }
}

TEST(OrientedBox, NamesItsAxesByDecreasingExtentRightHanded) {
  const OrientedBox box =
      make_box(Eigen::Matrix3f::Identity(), Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1, 3, 2));

  EXPECT_TRUE(box.extent.isApprox(Eigen::Vector3f(3, 2, 1)));
  EXPECT_TRUE(box.centre.isApprox(Eigen::Vector3f(0.5F, 1.5F, 1)));
  EXPECT_NEAR(std::abs((box.orientation * Eigen::Vector3f::UnitX()).y()), 1, 1e-5);
  EXPECT_NEAR(std::abs((box.orientation * Eigen::Vector3f::UnitY()).z()), 1, 1e-5);
}

TEST(OrientedBox, OfOnePointHasNoExtent) {
  const OrientedBox box = box_around({{Eigen::Vector3f(1, 2, 3), -Eigen::Vector3f::UnitZ()}});

  EXPECT_TRUE(box.centre.isApprox(Eigen::Vector3f(1, 2, 3), 1e-4F));
  EXPECT_EQ(box.extent, Eigen::Vector3f::Zero());
}

}  // namespace
}  // namespace cleave::segmentation
