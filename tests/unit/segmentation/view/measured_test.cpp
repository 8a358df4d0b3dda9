// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/measured.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "stored_scene.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"

namespace cleave::segmentation {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(Measured, AreFinitePointsOtherThanTheOrigin) {
  EXPECT_TRUE(is_measured(0, 0, 1));
  EXPECT_TRUE(is_measured(0, std::numeric_limits<float>::denorm_min(), 0));
  EXPECT_TRUE(is_measured(std::numeric_limits<float>::max(), -1, -1));
  EXPECT_FALSE(is_measured(0, 0, 0));
  EXPECT_FALSE(is_measured(-0.0F, 0, -0.0F));
  EXPECT_FALSE(is_measured(1, nan, 1));
  EXPECT_FALSE(is_measured(infinity, 0, 1));
  EXPECT_FALSE(is_measured(1, 1, -infinity));
}

TEST(Measured, IsNothingWhereZerosAreWrittenForNaN) {
  const DepthScene scene(2);
  std::vector<float> zeros = scene.xyz;
  for (float& coordinate : zeros) coordinate = std::isnan(coordinate) ? 0 : coordinate;
  for (const Representation representation : {Representation::cells, Representation::voxels}) {
    for (const bool organised : {true, false}) {
      Options options;
      options.representation = representation;
      CloudView view = scene.view();
      if (!organised) view = {view.xyz, 3, view.width * view.height, 1};
      const auto with_nan = segmented(view, options).labels;
      view.xyz = zeros.data();

      EXPECT_EQ(segmented(view, options).labels, with_nan);
    }
  }
}

}  // namespace
}  // namespace cleave::segmentation
