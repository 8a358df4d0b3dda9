// SPDX-License-Identifier: BSD-3-Clause
// Problems that may come with every frame: each kind is logged once a second at most, and the last
// one of any kind is kept for the status, for as long as it is news.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "libcleave/process/logging.hpp"

namespace cleave::service {

class ProblemLog {
 public:
  enum class Severity { warning, error };

  explicit ProblemLog(std::chrono::milliseconds kept = std::chrono::seconds(10)) : kept_(kept) {}

  // One limiter a kind of problem. From any thread.
  void report(Severity severity, LogLimiter& limiter, const std::string& what);
  // Empty: none in the time that one is kept.
  [[nodiscard]] std::string last() const;

 private:
  std::chrono::milliseconds kept_;
  mutable std::mutex mutex_;  // guards the two below
  std::string last_;
  std::chrono::steady_clock::time_point reported_{};
};

}  // namespace cleave::service
