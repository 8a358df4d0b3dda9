// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cleave::workbench {
namespace {

using evaluation::LabelledCloud;

// A plane z = 1 with x = column, y = row; labels count the pixels from 1.
LabelledCloud image(std::uint32_t width, std::uint32_t height) {
  LabelledCloud cloud{.width = width, .height = height, .xyz = {}, .label = {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      cloud.xyz.insert(cloud.xyz.end(), {static_cast<float>(x), static_cast<float>(y), 1.0F});
      cloud.label.push_back(y * width + x + 1);
    }
  }
  return cloud;
}

TEST(Quarter, TakesEverySecondColumnAndRow) {
  const LabelledCloud small = quarter(image(4, 4));

  EXPECT_EQ(small.width, 2U);
  EXPECT_EQ(small.height, 2U);
  EXPECT_EQ(small.label, (std::vector<std::uint32_t>{1, 3, 9, 11}));
  EXPECT_EQ(small.xyz, (std::vector<float>{0, 0, 1, 2, 0, 1, 0, 2, 1, 2, 2, 1}));
}

TEST(Quarter, TakesEveryFourthPointOfAnUnorganisedCloud) {
  const LabelledCloud small = quarter(image(9, 1));

  EXPECT_EQ(small.height, 1U);
  EXPECT_EQ(small.label, (std::vector<std::uint32_t>{1, 5}));
}

TEST(Quadruple, PutsMeansBetweenPixelsOfOneSurface) {
  const LabelledCloud large = quadruple(image(2, 2));

  ASSERT_EQ(large.width, 4U);
  ASSERT_EQ(large.height, 4U);
  ASSERT_EQ(large.xyz.size(), 3 * large.size());
  EXPECT_FLOAT_EQ(large.xyz[0], 0);         // the pixel itself
  EXPECT_FLOAT_EQ(large.xyz[3], 0.5F);      // between the two of the first row
  EXPECT_FLOAT_EQ(large.xyz[3 * 5], 0.5F);  // between all four
  EXPECT_FLOAT_EQ(large.xyz[3 * 5 + 1], 0.5F);
  EXPECT_EQ(large.label[5], 1U);
  EXPECT_EQ(large.label[15], 4U);
}

TEST(Quadruple, DoesNotBridgeDepthEdgesOrHoles) {
  LabelledCloud cloud = image(3, 2);
  cloud.xyz[3 * 1 + 2] = 2;
  cloud.xyz[3 * 2 + 2] = std::numeric_limits<float>::quiet_NaN();

  const LabelledCloud large = quadruple(cloud);

  EXPECT_FLOAT_EQ(large.xyz[3 * 1 + 2], 1);
  EXPECT_FLOAT_EQ(large.xyz[3 * 2 + 2], 2);
  EXPECT_FLOAT_EQ(large.xyz[3 * 3 + 2], 2);
  EXPECT_TRUE(std::isnan(large.xyz[3 * 4 + 2]));
}

TEST(Quadruple, RepeatsThePointsOfAnUnorganisedCloud) {
  const LabelledCloud large = quadruple(image(3, 1));

  EXPECT_EQ(large.width, 12U);
  EXPECT_EQ(large.label, (std::vector<std::uint32_t>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
  EXPECT_NEAR(large.xyz[3 * 5], 1, 0.001);
}

}  // namespace
}  // namespace cleave::workbench
