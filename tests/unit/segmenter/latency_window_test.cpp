// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/latency_window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace cleave::service {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t second = 1'000 * ms;

// The smallest value that at least `percent` per cent of the values do not exceed.
float naive_percentile_ms(const std::vector<std::int64_t>& values, std::size_t percent) {
  std::int64_t best = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t candidate : values) {
    const auto not_above = static_cast<std::size_t>(std::count_if(
        values.begin(), values.end(), [&](std::int64_t value) { return value <= candidate; }));
    if (not_above * 100 >= percent * values.size()) best = std::min(best, candidate);
  }
  return static_cast<float>(static_cast<double>(best) * 1e-6);
}

TEST(LatencyWindow, IsAllZeroWithoutFrames) {
  const LatencyWindow window;

  EXPECT_EQ(window.latency().median_ms, 0);
  EXPECT_EQ(window.latency().p99_ms, 0);
  EXPECT_EQ(window.rate_hz(second), 0);
}

TEST(LatencyWindow, AgreesWithACountingOracleOverTheLast300Frames) {
  std::mt19937 random(1);
  for (const std::size_t count : {1U, 2U, 99U, 300U, 777U}) {
    LatencyWindow window;
    std::vector<std::int64_t> latencies;
    for (std::size_t i = 0; i < count; ++i) {
      const auto now = static_cast<std::int64_t>(i + 1) * second;
      latencies.push_back(static_cast<std::int64_t>(random() % 100) * ms);
      window.add(now - latencies.back(), now);
    }
    const std::size_t kept = std::min(count, LatencyWindow::capacity);
    latencies.erase(latencies.begin(), latencies.end() - static_cast<std::ptrdiff_t>(kept));

    EXPECT_EQ(window.latency().median_ms, naive_percentile_ms(latencies, 50)) << count;
    EXPECT_EQ(window.latency().p90_ms, naive_percentile_ms(latencies, 90)) << count;
    EXPECT_EQ(window.latency().p99_ms, naive_percentile_ms(latencies, 99)) << count;
  }
}

TEST(LatencyWindow, CountsTheFramesOfTheLastTwoSeconds) {
  LatencyWindow window;
  for (std::int64_t i = 1; i <= 90; ++i) window.add(0, i * second / 30);

  EXPECT_FLOAT_EQ(window.rate_hz(3 * second), 30);
  EXPECT_FLOAT_EQ(window.rate_hz(4 * second), 15);
  EXPECT_FLOAT_EQ(window.rate_hz(6 * second), 0);
}

TEST(LatencyWindow, MeasuresRatesBeyondItsCapacity) {
  LatencyWindow window;
  for (std::int64_t i = 0; i <= 1000; ++i) window.add(0, i * ms);

  EXPECT_NEAR(window.rate_hz(1000 * ms), 1000, 5);
}

TEST(LatencyWindow, BelievesNoStartInTheFutureOrBeforeTheClocksZero) {
  LatencyWindow window;
  window.add(2 * second, second);
  window.add(std::numeric_limits<std::int64_t>::min(), second);
  window.add(std::numeric_limits<std::int64_t>::max(), second);

  EXPECT_EQ(window.latency().p99_ms, 0);
  EXPECT_GT(window.rate_hz(second), 0);
}

}  // namespace
}  // namespace cleave::service
