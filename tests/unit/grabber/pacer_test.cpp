// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/pacer.hpp"

#include <gtest/gtest.h>

namespace cleave::sensor {
namespace {

using std::chrono::milliseconds;
const Pacer::Clock::time_point pacer_start = Pacer::Clock::time_point() + std::chrono::hours(1);

TEST(Pacer, LetsTheFirstFrameThroughAtOnce) {
  EXPECT_EQ(Pacer(10).until_due(pacer_start), milliseconds(0));
}

TEST(Pacer, SpacesFramesByThePeriod) {
  Pacer pacer(10);
  pacer.advance(pacer_start);
  EXPECT_EQ(pacer.until_due(pacer_start), milliseconds(100));
  EXPECT_EQ(pacer.until_due(pacer_start + milliseconds(60)), milliseconds(40));
  EXPECT_EQ(pacer.until_due(pacer_start + milliseconds(130)), milliseconds(0));
}

TEST(Pacer, KeepsTheTimingOfARecording) {
  Pacer pacer(10);
  pacer.advance(pacer_start, milliseconds(40));
  EXPECT_EQ(pacer.until_due(pacer_start), milliseconds(40));
  pacer.advance(pacer_start + milliseconds(40), milliseconds(250));
  EXPECT_EQ(pacer.until_due(pacer_start + milliseconds(40)), milliseconds(250));
}

TEST(Pacer, MakesUpForLatenessOfLessThanAPeriod) {
  Pacer pacer(10);
  pacer.advance(pacer_start);
  pacer.advance(pacer_start + milliseconds(130));
  EXPECT_EQ(pacer.until_due(pacer_start + milliseconds(130)), milliseconds(70));
}

TEST(Pacer, BeginsAnewAfterAPauseWithoutABurst) {
  Pacer pacer(10);
  pacer.advance(pacer_start);
  pacer.advance(pacer_start + milliseconds(5000));
  EXPECT_EQ(pacer.until_due(pacer_start + milliseconds(5000)), milliseconds(100));
}

}  // namespace
}  // namespace cleave::sensor
