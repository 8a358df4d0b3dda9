// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/decimating_source.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/grabber/one_frame.hpp"

namespace cleave::sensor {
namespace {

using test::OneFrame;

TEST(DecimatingSource, MakesAnImageSmallerAndKeepsTimesCountsAndEnds) {
  DecimatingSource source(std::make_unique<OneFrame>(4, 2), 2);
  Frame frame;
  ASSERT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::frame);
  EXPECT_EQ(frame.width, 2U);
  EXPECT_EQ(frame.height, 1U);
  EXPECT_EQ(frame.intrinsics, (Intrinsics{50, 50, .5F, 0}));
  EXPECT_EQ(frame.capture_time_ns, 7);
  EXPECT_EQ(frame.device_time_us, 9U);
  EXPECT_TRUE(frame.begins_epoch);
  std::vector<float> xyz(6);
  source.write_points(xyz.data());
  EXPECT_EQ(xyz, (std::vector<float>{-.01F, 0, 1, .01F, 0, 1}));
  EXPECT_EQ(source.counts().sensor_drops, 3U);
  EXPECT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::end);
}

TEST(DecimatingSource, LeavesACloudThatIsNoImageAsItIs) {
  DecimatingSource source(std::make_unique<OneFrame>(3, 1), 2);
  Frame frame;
  ASSERT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::frame);
  EXPECT_EQ(frame.width, 3U);
  std::vector<float> xyz(9);
  source.write_points(xyz.data());
  EXPECT_EQ(xyz, (std::vector<float>{0, 0, 1, 1, 0, 1, 2, 0, 1}));
}

}  // namespace
}  // namespace cleave::sensor
