// SPDX-License-Identifier: BSD-3-Clause
#include "recording/units/unit.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace cleave::recording {
namespace {

TEST(Unit, IsKnownByItsNameAlone) {
  EXPECT_EQ(unit_named("m"), Unit::metre);
  EXPECT_EQ(unit_named("cm"), Unit::centimetre);
  EXPECT_EQ(unit_named("mm"), Unit::millimetre);
  EXPECT_EQ(unit_named("in"), std::nullopt);
  EXPECT_EQ(unit_named(""), std::nullopt);
}

TEST(Unit, ScalesToTheNearestMetre) {
  std::vector<float> xyz = {1234, -0.5F, std::numeric_limits<float>::infinity()};

  scale_to_metres(xyz, Unit::millimetre);

  EXPECT_EQ(xyz, (std::vector<float>{1.234F, -0.0005F, std::numeric_limits<float>::infinity()}));
}

TEST(Unit, OfMetresLeavesEveryBitAlone) {
  std::vector<float> xyz = {1e-41F, 3.4e38F, -0.0F};
  const std::vector<float> before = xyz;

  scale_to_metres(xyz, Unit::metre);

  EXPECT_EQ(xyz, before);
}

}  // namespace
}  // namespace cleave::recording
