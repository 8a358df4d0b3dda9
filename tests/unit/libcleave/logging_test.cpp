// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/logging.hpp"

#include <gtest/gtest.h>

namespace cleave {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
const LogLimiter::Clock::time_point limiter_start =
    LogLimiter::Clock::time_point() + std::chrono::hours(1);

TEST(LogLimiter, LetsOneThroughAnIntervalAndTellsTheNextHowManyItSwallowed) {
  LogLimiter limiter(seconds(1));
  std::uint64_t suppressed = 99;

  EXPECT_TRUE(limiter.allow(suppressed, limiter_start));
  EXPECT_EQ(suppressed, 0U);
  for (const int after_ms : {0, 500, 999}) {
    EXPECT_FALSE(limiter.allow(suppressed, limiter_start + milliseconds(after_ms)));
  }
  EXPECT_TRUE(limiter.allow(suppressed, limiter_start + seconds(1)));
  EXPECT_EQ(suppressed, 3U);
}

TEST(LogLimiter, CountsAnewOnceItHasTold) {
  LogLimiter limiter(seconds(1));
  std::uint64_t suppressed = 0;
  (void)limiter.allow(suppressed, limiter_start);
  (void)limiter.allow(suppressed, limiter_start);
  (void)limiter.allow(suppressed, limiter_start + seconds(1));
  ASSERT_EQ(suppressed, 1U);

  EXPECT_FALSE(limiter.allow(suppressed, limiter_start + milliseconds(1999)));
  EXPECT_TRUE(limiter.allow(suppressed, limiter_start + seconds(2)));
  EXPECT_EQ(suppressed, 1U);
}

TEST(LogLimiter, HasNothingToTellAfterASilence) {
  LogLimiter limiter(seconds(1));
  std::uint64_t suppressed = 99;
  (void)limiter.allow(suppressed, limiter_start);

  EXPECT_TRUE(limiter.allow(suppressed, limiter_start + std::chrono::hours(1)));
  EXPECT_EQ(suppressed, 0U);
}

}  // namespace
}  // namespace cleave
