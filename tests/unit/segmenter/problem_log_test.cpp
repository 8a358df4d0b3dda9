// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/problem_log.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace cleave::service {
namespace {

using std::chrono::milliseconds;

TEST(ProblemLog, KeepsTheLastProblem) {
  ProblemLog log;
  LogLimiter limiter;
  EXPECT_EQ(log.last(), "");
  log.report(ProblemLog::Severity::warning, limiter, "too hot");
  log.report(ProblemLog::Severity::warning, limiter, "too cold");
  EXPECT_EQ(log.last(), "too cold");
}

TEST(ProblemLog, ForgetsAProblemThatIsOver) {
  ProblemLog log(milliseconds(1));
  LogLimiter limiter;
  log.report(ProblemLog::Severity::warning, limiter, "too hot");
  std::this_thread::sleep_for(milliseconds(5));
  EXPECT_EQ(log.last(), "");
}

}  // namespace
}  // namespace cleave::service
