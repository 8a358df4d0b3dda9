// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/replay/replay_clock.hpp"

#include <gtest/gtest.h>

namespace cleave::client {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using std::chrono_literals::operator""h;

const ReplayClock::Clock::time_point start = ReplayClock::Clock::time_point() + 1h;
constexpr std::int64_t ms_ns = 1'000'000;

TEST(ReplayClock, KeepsTheRecordingsTiming) {
  ReplayClock clock(1);
  EXPECT_LE(clock.until_due(500 * ms_ns, 0, start), 0ms);
  EXPECT_EQ(clock.until_due(540 * ms_ns, 0, start), 40ms);
  EXPECT_EQ(clock.until_due(600 * ms_ns, 0, start + 30ms), 70ms);
}

TEST(ReplayClock, GoesFasterOrSlowerByTheRate) {
  ReplayClock twice(2);
  (void)twice.until_due(0, 0, start);
  EXPECT_EQ(twice.until_due(100 * ms_ns, 0, start), 50ms);
  ReplayClock half(0.5);
  (void)half.until_due(0, 0, start);
  EXPECT_EQ(half.until_due(100 * ms_ns, 0, start), 200ms);
}

TEST(ReplayClock, NeverWaitsWithoutARate) {
  ReplayClock clock(0);
  (void)clock.until_due(0, 0, start);
  EXPECT_LE(clock.until_due(3600'000 * ms_ns, 0, start), 0ms);
}

TEST(ReplayClock, BeginsAnewAfterALongStopAndWithEachPass) {
  ReplayClock clock(1);
  (void)clock.until_due(0, 0, start);
  EXPECT_LE(clock.until_due(100 * ms_ns, 0, start + 10s), 0ms);
  EXPECT_EQ(clock.until_due(150 * ms_ns, 0, start + 10s), 50ms);
  EXPECT_LE(clock.until_due(0, 1, start + 11s), 0ms);
  EXPECT_EQ(clock.until_due(30 * ms_ns, 1, start + 11s), 30ms);
}

TEST(ReplayClock, PlaysOnAfterTheLongestGapWhenTheRecordingsClockJumps) {
  constexpr std::int64_t day_ns = 86'400'000 * ms_ns;
  ReplayClock clock(1, recording::GapLimit(1));
  (void)clock.until_due(0, 0, start);
  EXPECT_FALSE(clock.new_jump());
  const std::int64_t after = 11 * day_ns;
  EXPECT_EQ(clock.until_due(after, 0, start), 1s);
  EXPECT_EQ(clock.until_due(after, 0, start + 400ms), 600ms);
  EXPECT_EQ(clock.until_due(after + 30 * ms_ns, 0, start + 1s), 30ms);
  EXPECT_TRUE(clock.new_jump());
  EXPECT_LE(clock.until_due(0, 0, start + 1030ms), 0ms) << "and back again";
  EXPECT_EQ(clock.until_due(30 * ms_ns, 0, start + 1030ms), 30ms);
  EXPECT_FALSE(clock.new_jump()) << "it is said once";
}

TEST(ReplayClock, KeepsAPauseThatWasRecordedOnPurpose) {
  ReplayClock clock(0.5, recording::GapLimit(10));
  (void)clock.until_due(0, 0, start);
  EXPECT_EQ(clock.until_due(9'000 * ms_ns, 0, start), 18s);
  EXPECT_FALSE(clock.new_jump());
}

}  // namespace
}  // namespace cleave::client
