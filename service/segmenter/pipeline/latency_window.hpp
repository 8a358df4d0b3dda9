// SPDX-License-Identifier: BSD-3-Clause
// How long the last frames took, and how many came a second. Fixed memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace cleave::service {

struct LatencySummary {
  float median_ms = 0;
  float p90_ms = 0;
  float p99_ms = 0;
};

// Safe to use from several threads. Times are CLOCK_MONOTONIC.
class LatencyWindow {
 public:
  static constexpr std::size_t capacity = 300;  // frames: 10 s of a camera
  static constexpr std::int64_t rate_span_ns = 2'000'000'000;

  // A frame that began at `from_ns` and was done at `to_ns`, not earlier than the one added before.
  // The two come from different processes: a start that lies in the future, or before the clock's
  // zero, is no time of this machine, and its frame counts for the rate only.
  void add(std::int64_t from_ns, std::int64_t to_ns);

  // Percentiles by nearest rank over the last 300 latencies; all 0 while there is none.
  [[nodiscard]] LatencySummary latency() const;
  // Frames a second over the 2 s before `now_ns`.
  [[nodiscard]] float rate_hz(std::int64_t now_ns) const;

 private:
  // The last `capacity` values; where `next` points the oldest stands, once full.
  struct Ring {
    std::array<std::int64_t, capacity> values_ns{};
    std::size_t size = 0;
    std::size_t next = 0;
    void add(std::int64_t value_ns);
  };
  mutable std::mutex mutex_;  // guards the two below
  Ring latencies_;
  Ring done_;
};

}  // namespace cleave::service
