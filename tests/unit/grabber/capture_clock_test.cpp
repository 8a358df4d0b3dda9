// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/capture_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

namespace cleave::sensor {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t start_ns = 5'000'000 * ms;

// Ten minutes at 30 Hz. Frames arrive 4 ms late or up to 12 ms later still; the device's clock is
// fast by `drift`. The largest error of the capture time after the first ten seconds, the constant
// 4 ms not counted.
double largest_error_ms(double drift) {
  CaptureClock clock;
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int64_t> jitter_ns(0, 12 * ms);
  double largest = 0;
  for (int i = 0; i < 18000; ++i) {
    const std::int64_t captured_ns = i * 33'333'333LL;
    const auto device_us = static_cast<std::uint64_t>(
        std::llround(static_cast<double>(captured_ns) * (1 + drift) / 1000));
    const std::int64_t arrival_ns = start_ns + captured_ns + 4 * ms + jitter_ns(random);
    const CaptureClock::Stamp stamp = clock.stamp(device_us, arrival_ns);
    EXPECT_FALSE(stamp.reset);
    const std::int64_t error_ns = arrival_ns - stamp.delay_ns - (start_ns + captured_ns + 4 * ms);
    if (i > 300) largest = std::max(largest, std::abs(static_cast<double>(error_ns)) / ms);
  }
  return largest;
}

TEST(CaptureClock, FollowsAClockThatIsFastBy200Ppm) {
  EXPECT_LT(largest_error_ms(200e-6), 2);
}

TEST(CaptureClock, FollowsAClockThatIsSlowBy200Ppm) {
  EXPECT_LT(largest_error_ms(-200e-6), 2);
}

TEST(CaptureClock, NeverPutsACaptureAfterItsArrival) {
  CaptureClock clock;
  std::mt19937 random(5);
  for (std::int64_t i = 0; i < 1000; ++i) {
    const std::int64_t arrival_ns =
        start_ns + i * 33 * ms + static_cast<std::int64_t>(random() % 20) * ms;
    EXPECT_GE(clock.stamp(static_cast<std::uint64_t>(i) * 33'000, arrival_ns).delay_ns, 0);
  }
}

TEST(CaptureClock, SeesAClockThatJumpsBack) {
  CaptureClock clock;
  EXPECT_FALSE(clock.stamp(9'000'000, start_ns).reset);
  EXPECT_FALSE(clock.stamp(9'033'000, start_ns + 33 * ms).reset);
  const CaptureClock::Stamp jumped = clock.stamp(0, start_ns + 66 * ms);
  EXPECT_TRUE(jumped.reset);
  EXPECT_EQ(jumped.delay_ns, 0);
  EXPECT_FALSE(clock.stamp(33'000, start_ns + 99 * ms).reset);
}

TEST(CaptureClock, SeesAClockThatJumpsAhead) {
  CaptureClock clock;
  EXPECT_FALSE(clock.stamp(1'000'000, start_ns).reset);
  EXPECT_TRUE(clock.stamp(9'000'000, start_ns + 33 * ms).reset);
  EXPECT_FALSE(clock.stamp(9'033'000, start_ns + 66 * ms).reset);
}

// The filter begins anew with the reset: ten minutes of 200 ppm before it do not count.
TEST(CaptureClock, FollowsTheDriftFromTheStartAgainAfterAReset) {
  CaptureClock clock;
  std::mt19937 random(11);
  const auto stamp_at = [&](std::int64_t captured_ns, std::int64_t zero_ns) {
    const auto device_us =
        static_cast<std::uint64_t>((captured_ns - zero_ns) / 1000 * 9998 / 10000);
    const std::int64_t delay_ns = 4 * ms + static_cast<std::int64_t>(random() % 12) * ms;
    const auto stamp = clock.stamp(device_us, start_ns + captured_ns + delay_ns);
    return std::pair(stamp, delay_ns - 4 * ms - stamp.delay_ns);
  };
  for (std::int64_t i = 0; i < 18000; ++i) (void)stamp_at(i * 33 * ms, 0);
  const std::int64_t reset_ns = 18000 * 33 * ms;
  EXPECT_TRUE(stamp_at(reset_ns, reset_ns).first.reset);
  for (std::int64_t i = 1; i < 18000; ++i) {
    const auto [stamp, error_ns] = stamp_at(reset_ns + i * 33 * ms, reset_ns);
    ASSERT_FALSE(stamp.reset);
    if (i > 300) {
      ASSERT_LT(std::abs(error_ns), 3 * ms) << i;
    }
  }
}

TEST(CaptureClock, TakesALateFrameForLateAndNotForAReset) {
  CaptureClock clock;
  EXPECT_FALSE(clock.stamp(0, start_ns).reset);
  const CaptureClock::Stamp late = clock.stamp(33'000, start_ns + 10'033 * ms);
  EXPECT_FALSE(late.reset);
  EXPECT_NEAR(static_cast<double>(late.delay_ns) / ms, 10'000, 3);
  EXPECT_FALSE(clock.stamp(10'066'000, start_ns + 10'066 * ms).reset);
}

}  // namespace
}  // namespace cleave::sensor
