// SPDX-License-Identifier: BSD-3-Clause
// Logs go to stderr through spdlog; data goes to stdout.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace cleave {

// "2026-01-31 12:00:00.000 cleave-grabber warning: ..." on stderr, level from CLEAVE_LOG
// (trace, debug, info, warning, error; info by default).
void init_logging(const std::string& program);

// Lets one message through an interval and counts the rest, for causes that repeat at frame rate.
class LogLimiter {
 public:
  using Clock = std::chrono::steady_clock;

  explicit LogLimiter(std::chrono::milliseconds interval = std::chrono::seconds(1))
      : interval_(interval) {}
  // True: log now; `suppressed` is how many were swallowed since the last time. From any thread.
  [[nodiscard]] bool allow(std::uint64_t& suppressed, Clock::time_point now = Clock::now());

 private:
  std::chrono::milliseconds interval_;
  std::mutex mutex_;  // guards the two below
  Clock::time_point next_{};
  std::uint64_t suppressed_ = 0;
};

}  // namespace cleave
