// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/problem_log.hpp"

#include <spdlog/spdlog.h>

#include <cstdint>

namespace cleave::service {

void ProblemLog::report(Severity severity, LogLimiter& limiter, const std::string& what) {
  {
    const std::lock_guard lock(mutex_);
    last_ = what;
    reported_ = std::chrono::steady_clock::now();
  }
  std::uint64_t suppressed = 0;
  if (!limiter.allow(suppressed)) return;
  const auto level = severity == Severity::error ? spdlog::level::err : spdlog::level::warn;
  if (suppressed == 0) {
    spdlog::log(level, "{}", what);
  } else {
    spdlog::log(level, "{} ({} more like this since the last message)", what, suppressed);
  }
}

std::string ProblemLog::last() const {
  const std::lock_guard lock(mutex_);
  return std::chrono::steady_clock::now() - reported_ < kept_ ? last_ : "";
}

}  // namespace cleave::service
