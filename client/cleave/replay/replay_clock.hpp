// SPDX-License-Identifier: BSD-3-Clause
// When a recorded frame is due.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "recording/frames/gap_limit.hpp"

namespace cleave::client {

// The recording's own timing, faster or slower by `rate`; 0 = every frame is due at once. Lateness
// is made up for, but after a stop of more than a second the clock is set anew, without a burst.
// Where the recording's own clock jumps, the next frame is due after the longest gap at most.
class ReplayClock {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ReplayClock(double rate, recording::GapLimit gaps = recording::GapLimit())
      : rate_(rate), gaps_(gaps) {}

  // Until the frame of this log time is due; zero or less if it is. To be asked of one frame after
  // the other, of each as often as need be. `pass` rises when the recording begins again: its first
  // frame follows at once.
  [[nodiscard]] Clock::duration until_due(std::int64_t log_time_ns, std::uint64_t pass,
                                          Clock::time_point now) {
    if (rate_ <= 0) return Clock::duration::zero();
    if (!start_ || pass != pass_) set(log_time_ns, pass, now);
    go_on_to(log_time_ns);
    const std::chrono::nanoseconds offset(
        static_cast<std::int64_t>(static_cast<double>(played_.count()) / rate_));
    const Clock::duration left = *start_ + offset - now;
    if (left >= -std::chrono::seconds(1)) return left;
    set(log_time_ns, pass, now);
    return Clock::duration::zero();
  }

  // The first jump that was met, in words; once.
  [[nodiscard]] std::optional<std::string> new_jump() {
    if (said_jump_ || !jump_) return std::nullopt;
    said_jump_ = true;
    return jump_;
  }

 private:
  void set(std::int64_t log_time_ns, std::uint64_t pass, Clock::time_point now) {
    start_ = now;
    played_ = {};
    log_ns_ = log_time_ns;
    pass_ = pass;
  }

  void go_on_to(std::int64_t log_time_ns) {
    const recording::GapLimit::Gap gap = gaps_.between(log_ns_, log_time_ns);
    if (gap.is_jump && !jump_) jump_ = gaps_.text_of_jump(log_ns_, log_time_ns);
    played_ += gap.wait;
    log_ns_ = log_time_ns;
  }

  double rate_;
  recording::GapLimit gaps_;
  std::optional<Clock::time_point> start_;
  std::chrono::nanoseconds played_{};  // of the recording, since the start
  std::int64_t log_ns_ = 0;            // of the frame that was asked for last
  std::uint64_t pass_ = 0;
  std::optional<std::string> jump_;
  bool said_jump_ = false;
};

}  // namespace cleave::client
