// SPDX-License-Identifier: BSD-3-Clause
// When to try again what failed.
#pragma once

#include <algorithm>
#include <chrono>

namespace cleave::sensor {

// Waits of 0.1 s, then twice as long each time, up to 2 s.
class Backoff {
 public:
  using Clock = std::chrono::steady_clock;

  // The first attempt is due a first wait after `now`.
  void start(Clock::time_point now) {
    wait_ = first_wait;
    next_ = now + wait_;
  }
  void failed(Clock::time_point now) {
    wait_ = std::min(2 * wait_, last_wait);
    next_ = now + wait_;
  }
  [[nodiscard]] bool due(Clock::time_point now) const { return now >= next_; }

 private:
  static constexpr std::chrono::milliseconds first_wait{100};
  static constexpr std::chrono::milliseconds last_wait{2000};
  std::chrono::milliseconds wait_ = first_wait;
  Clock::time_point next_{};
};

}  // namespace cleave::sensor
