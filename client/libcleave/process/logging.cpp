// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/logging.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <utility>

namespace cleave {

void init_logging(const std::string& program) {
  auto logger = spdlog::stderr_color_mt(program);
  logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %n %^%l%$: %v");
  logger->flush_on(spdlog::level::info);
  if (const char* const level = std::getenv("CLEAVE_LOG")) {
    logger->set_level(spdlog::level::from_str(level));
  }
  spdlog::set_default_logger(std::move(logger));
}

bool LogLimiter::allow(std::uint64_t& suppressed, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (now < next_) {
    ++suppressed_;
    return false;
  }
  next_ = now + interval_;
  suppressed = std::exchange(suppressed_, 0);
  return true;
}

}  // namespace cleave
