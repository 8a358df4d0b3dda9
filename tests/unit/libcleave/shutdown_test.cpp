// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/shutdown.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

namespace cleave {
namespace {

class ShutdownOnSignal : public testing::TestWithParam<int> {};

TEST_P(ShutdownOnSignal, RunsTheActionAndWakesWaiters) {
  Shutdown shutdown;
  std::atomic<int> runs{0};
  shutdown.on_request([&] { ++runs; });
  EXPECT_FALSE(shutdown.requested());
  ::kill(::getpid(), GetParam());
  EXPECT_TRUE(shutdown.wait_for(std::chrono::seconds(30)));
  while (runs == 0) std::this_thread::yield();
  EXPECT_EQ(runs, 1);
}

INSTANTIATE_TEST_SUITE_P(Signals, ShutdownOnSignal, testing::Values(SIGINT, SIGTERM));

TEST(Shutdown, RunsALateActionAtOnce) {
  Shutdown shutdown;
  shutdown.request();
  int runs = 0;
  shutdown.on_request([&] { ++runs; });
  EXPECT_EQ(runs, 1);
}

TEST(Shutdown, TimesOutWhenNobodyAsks) {
  Shutdown shutdown;
  EXPECT_FALSE(shutdown.wait_for(std::chrono::milliseconds(1)));
}

TEST(ShutdownDeathTest, EndsTheProcessAtOnceOnASecondSignal) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        Shutdown shutdown;
        ::kill(::getpid(), SIGINT);
        (void)shutdown.wait_for(std::chrono::seconds(30));
        ::kill(::getpid(), SIGINT);
        ::pause();
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace cleave
