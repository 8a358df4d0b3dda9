// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/driver/fault_plan.hpp"

#include <gtest/gtest.h>

namespace cleave::driver {
namespace {

using std::chrono::milliseconds;
const FaultPlan::Clock::time_point made{std::chrono::hours(1)};
const FaultPlan::Clock::time_point start = made + milliseconds(5000);

TEST(FaultPlan, CountsTimeFromTheFirstFrame) {
  render::CameraFaults faults;
  faults.stall_at_ms = 100;
  faults.stall_ms = 50;
  FaultPlan plan(faults, 30, made);
  EXPECT_FALSE(plan.silent(made + milliseconds(120)));
  EXPECT_TRUE(plan.first_frame(start));
  EXPECT_FALSE(plan.first_frame(start + milliseconds(110)));
  EXPECT_FALSE(plan.silent(start + milliseconds(99)));
  EXPECT_TRUE(plan.silent(start + milliseconds(100)));
  EXPECT_TRUE(plan.silent(start + milliseconds(149)));
  EXPECT_FALSE(plan.silent(start + milliseconds(150)));
  EXPECT_FALSE(plan.unplugged(start + milliseconds(120)));
}

TEST(FaultPlan, IsAwayBetweenUnpluggingAndPluggingInAgain) {
  render::CameraFaults faults;
  faults.unplug_at_ms = 100;
  faults.replug_after_ms = 50;
  FaultPlan plan(faults, 30, made);
  EXPECT_FALSE(plan.absence());
  EXPECT_TRUE(plan.first_frame(start));
  ASSERT_TRUE(plan.absence());
  EXPECT_EQ(plan.absence()->from, start + milliseconds(100));
  EXPECT_EQ(plan.absence()->to, start + milliseconds(150));
  EXPECT_TRUE(plan.unplugged(start + milliseconds(120)));
  EXPECT_TRUE(plan.silent(start + milliseconds(120)));
  EXPECT_FALSE(plan.unplugged(start + milliseconds(150)));
}

TEST(FaultPlan, IsInUseFromWhenItIsKnown) {
  render::CameraFaults faults;
  faults.in_use_ms = 100;
  const FaultPlan plan(faults, 30, made);
  EXPECT_TRUE(plan.in_use(made + milliseconds(99)));
  EXPECT_FALSE(plan.in_use(made + milliseconds(100)));
}

TEST(FaultPlan, DropsAsManyFramesAsItIsToldTo) {
  render::CameraFaults faults;
  faults.drop_at_ms = 100;
  faults.drop_frames = 3;
  FaultPlan plan(faults, 20, made);
  EXPECT_TRUE(plan.first_frame(start));
  int dropped = 0;
  for (int i = 0; i < 20; ++i) dropped += plan.drops(start + i * milliseconds(50)) ? 1 : 0;
  EXPECT_EQ(dropped, 3);
}

TEST(FaultPlan, KnowsWhenTheClockWasResetOnceItWas) {
  render::CameraFaults faults;
  faults.clock_reset_at_ms = 100;
  FaultPlan plan(faults, 30, made);
  EXPECT_TRUE(plan.first_frame(start));
  EXPECT_FALSE(plan.clock_reset(start + milliseconds(99)));
  EXPECT_EQ(plan.clock_reset(start + milliseconds(200)), start + milliseconds(100));
}

TEST(FaultPlan, HasNoFaultUnlessToldSo) {
  FaultPlan plan({}, 30, made);
  EXPECT_TRUE(plan.first_frame(start));
  for (int i = 0; i < 10'000; ++i) {
    const auto now = start + milliseconds(i);
    ASSERT_FALSE(plan.silent(now) || plan.drops(now) || plan.in_use(now) || plan.clock_reset(now));
  }
}

}  // namespace
}  // namespace cleave::driver
