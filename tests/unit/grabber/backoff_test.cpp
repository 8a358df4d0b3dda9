// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/backoff.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cleave::sensor {
namespace {

using std::chrono::milliseconds;

TEST(Backoff, WaitsTwiceAsLongEachTimeUpToTwoSeconds) {
  Backoff::Clock::time_point now{std::chrono::hours(1)};
  Backoff backoff;
  backoff.start(now);
  for (const int wait_ms : {100, 200, 400, 800, 1600, 2000, 2000}) {
    EXPECT_FALSE(backoff.due(now + milliseconds(wait_ms - 1)));
    now += milliseconds(wait_ms);
    EXPECT_TRUE(backoff.due(now));
    backoff.failed(now);
  }
  backoff.start(now);
  EXPECT_TRUE(backoff.due(now + milliseconds(100))) << "the next loss begins anew";
}

}  // namespace
}  // namespace cleave::sensor
