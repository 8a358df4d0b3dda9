// SPDX-License-Identifier: BSD-3-Clause
// The pace of sources that have none of their own.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

namespace cleave::sensor {

// Frames are due one period apart. Lateness of less than a period is made up for; after a longer
// pause the pace begins anew, without a burst.
class Pacer {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Pacer(std::uint32_t fps)
      : period_(std::chrono::duration_cast<Clock::duration>(std::chrono::seconds(1)) / fps) {}

  // Until the next frame is due; zero if it is.
  [[nodiscard]] Clock::duration until_due(Clock::time_point now) const {
    return std::max(next_ - now, Clock::duration::zero());
  }
  // A frame was handed out, and the next one is due a period later, or after `until_next`.
  void advance(Clock::time_point now, std::optional<Clock::duration> until_next = std::nullopt) {
    next_ = (now - next_ > period_ ? now : next_) + until_next.value_or(period_);
  }

 private:
  Clock::duration period_;
  Clock::time_point next_{};
};

}  // namespace cleave::sensor
