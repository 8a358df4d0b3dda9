// Problems that may come with every frame: each kind is logged once a second at most, and the last
// one of any kind is kept for the status.
#pragma once

#include <mutex>
#include <string>

#include "libcleave/logging.hpp"

namespace cleave::service {

class ProblemLog {
 public:
  enum class Severity { warning, error };

  // One limiter a kind of problem. From any thread.
  void report(Severity severity, LogLimiter& limiter, const std::string& what);
  // Empty: none so far.
  [[nodiscard]] std::string last() const;

 private:
  mutable std::mutex mutex_;  // guards last_
  std::string last_;
};

}  // namespace cleave::service
