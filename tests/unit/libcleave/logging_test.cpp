// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/logging.hpp"

#include <gtest/gtest.h>

namespace cleave {
namespace {

TEST(LogLimiter, LetsTheFirstThroughAndCountsTheRest) {
  LogLimiter limiter(std::chrono::hours(1));
  std::uint64_t suppressed = 99;
  EXPECT_TRUE(limiter.allow(suppressed));
  EXPECT_EQ(suppressed, 0U);
  EXPECT_FALSE(limiter.allow(suppressed));
}

TEST(LogLimiter, TellsHowManyItSwallowed) {
  LogLimiter limiter(std::chrono::milliseconds(0));
  std::uint64_t suppressed = 99;
  EXPECT_TRUE(limiter.allow(suppressed));
  EXPECT_TRUE(limiter.allow(suppressed));
  EXPECT_EQ(suppressed, 0U);
}

}  // namespace
}  // namespace cleave
