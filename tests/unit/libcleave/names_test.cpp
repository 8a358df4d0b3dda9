// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "libcleave/types.hpp"

namespace cleave {
namespace {

TEST(SensorName, MayHoldLettersDigitsAndUnderscore) {
  EXPECT_TRUE(is_valid_sensor_name("front_left_2"));
  EXPECT_FALSE(is_valid_sensor_name("front-left"));  // DDS refuses it in a topic name
  EXPECT_TRUE(is_valid_sensor_name(std::string(63, 'a')));
  EXPECT_FALSE(is_valid_sensor_name(""));
  EXPECT_FALSE(is_valid_sensor_name("a/b"));
  EXPECT_FALSE(is_valid_sensor_name("a b"));
}

TEST(SensorName, MayNotBeLongerThan63Characters) {
  EXPECT_FALSE(is_valid_sensor_name(std::string(64, 'a')));
}

TEST(Name, ComesBackFromTheHeaderAsItWasSet) {
  FrameHeader header{};
  ASSERT_TRUE(set_name(header.sensor, "camera"));
  EXPECT_EQ(name_of(header.sensor), "camera");
}

TEST(Name, ThatIsTooLongLeavesTheHeaderAsItWas) {
  FrameHeader header{};
  ASSERT_TRUE(set_name(header.sensor, "camera"));
  EXPECT_FALSE(set_name(header.sensor, std::string(64, 'x')));
  EXPECT_EQ(name_of(header.sensor), "camera");
}

TEST(Name, ThatDoesNotEndIsEmpty) {
  FrameHeader header{};
  std::memset(header.sensor, 'x', sizeof header.sensor);
  EXPECT_TRUE(name_of(header.sensor).empty());
}

TEST(PointCount, DoesNotOverflow) {
  FrameHeader header{};
  header.width = header.height = 0xFFFFFFFFU;
  EXPECT_EQ(point_count(header), 0xFFFFFFFE00000001U);
}

}  // namespace
}  // namespace cleave
