// When a recorded frame is due.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace cleave::client {

// The recording's own timing, faster or slower by `rate`; 0 = every frame is due at once. Lateness
// is made up for, but after a stop of more than a second the clock is set anew, without a burst.
class ReplayClock {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ReplayClock(double rate) : rate_(rate) {}

  // Until the frame of this log time is due; zero or less if it is. `pass` rises when the recording
  // begins again: its first frame follows at once.
  [[nodiscard]] Clock::duration until_due(std::int64_t log_time_ns, std::uint64_t pass,
                                          Clock::time_point now) {
    if (rate_ <= 0) return Clock::duration::zero();
    if (!start_ || pass != pass_) set(log_time_ns, pass, now);
    const std::chrono::nanoseconds offset(
        static_cast<std::int64_t>(static_cast<double>(log_time_ns - start_log_ns_) / rate_));
    const Clock::duration left = *start_ + offset - now;
    if (left >= -std::chrono::seconds(1)) return left;
    set(log_time_ns, pass, now);
    return Clock::duration::zero();
  }

 private:
  void set(std::int64_t log_time_ns, std::uint64_t pass, Clock::time_point now) {
    start_ = now;
    start_log_ns_ = log_time_ns;
    pass_ = pass;
  }
  double rate_;
  std::optional<Clock::time_point> start_;
  std::int64_t start_log_ns_ = 0;
  std::uint64_t pass_ = 0;
};

}  // namespace cleave::client
