// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "libcleave/roudi.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/libcleave/listening_socket.hpp"

namespace cleave {
namespace {

namespace fs = std::filesystem;

class WatchOfRouDi : public testing::Test {
 protected:
  WatchOfRouDi() { roudi_.emplace(file()); }

  [[nodiscard]] fs::path file() const { return folder_.path() / "roudi"; }
  void crash() { roudi_.reset(); }
  void start_another() {
    crash();
    fs::rename(file(),
               folder_.path() / "before");  // so that the next one cannot be given the same inode
    roudi_.emplace(file());
  }
  // What the watch says when it looks the next time.
  static bool look(RouDiWatch& watch) {
    static RouDiWatch::Clock::time_point now{};
    return watch.update(now += std::chrono::seconds(1));
  }

  tests::TemporaryFolder folder_;
  std::optional<test::ListeningSocket> roudi_;
};

TEST_F(WatchOfRouDi, HasNothingToSayWhileTheSameOneAnswers) {
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  EXPECT_FALSE(look(watch));
  EXPECT_FALSE(look(watch));
  EXPECT_EQ(watch.error(), "");
  EXPECT_FALSE(watch.restart_joins());
}

TEST_F(WatchOfRouDi, TellsOnceThatItIsGone) {
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  crash();
  EXPECT_TRUE(look(watch));
  EXPECT_NE(watch.error().find("RouDi is gone"), std::string::npos);
  EXPECT_FALSE(look(watch));
  EXPECT_FALSE(watch.restart_joins());
}

TEST_F(WatchOfRouDi, ForgetsTheErrorWhenTheSameOneIsBack) {
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  fs::rename(file(), folder_.path() / "away");
  ASSERT_TRUE(look(watch));
  ASSERT_NE(watch.error(), "");
  fs::rename(folder_.path() / "away", file());
  EXPECT_TRUE(look(watch));
  EXPECT_EQ(watch.error(), "");
  EXPECT_FALSE(watch.restart_joins());
}

TEST_F(WatchOfRouDi, TakesOneWhoseRightsHaveChangedForTheSame) {
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  fs::permissions(file(), fs::perms::owner_all);
  EXPECT_FALSE(look(watch));
  EXPECT_FALSE(watch.restart_joins());
}

TEST_F(WatchOfRouDi, SeesAnotherOneInItsPlaceAndKeepsTheError) {
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  crash();
  ASSERT_TRUE(look(watch));
  start_another();
  EXPECT_FALSE(look(watch));
  EXPECT_TRUE(watch.restart_joins());
  EXPECT_NE(watch.error(), "") << "until the restart";
}

TEST_F(WatchOfRouDi, SeesAnotherOneThatCameBetweenTwoLooks) {
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  ASSERT_FALSE(look(watch));
  start_another();
  EXPECT_FALSE(look(watch));
  EXPECT_TRUE(watch.restart_joins());
}

TEST_F(WatchOfRouDi, LooksOnceASecond) {
  const RouDiWatch::Clock::time_point now(std::chrono::hours(1));
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  EXPECT_FALSE(watch.update(now));
  crash();
  EXPECT_FALSE(watch.update(now + std::chrono::milliseconds(999)));
  EXPECT_TRUE(watch.update(now + std::chrono::seconds(1)));
}

TEST_F(WatchOfRouDi, MindsNoRouDiWhereSharedMemoryIsSwitchedOff) {
  RouDiWatch watch(RouDiWatch::Task::nothing, file());
  crash();
  EXPECT_FALSE(look(watch));
  start_another();
  EXPECT_FALSE(look(watch));
  EXPECT_EQ(watch.error(), "");
  EXPECT_FALSE(watch.restart_joins());
}

TEST_F(WatchOfRouDi, DoesNotTakeAnotherProgramOnItsSocketForTheOneThatItWaitsFor) {
  RouDiWatch watch(RouDiWatch::Task::wait, file());
  EXPECT_FALSE(look(watch));
  EXPECT_EQ(watch.error(), "");
  EXPECT_FALSE(watch.restart_joins());
}

TEST_F(WatchOfRouDi, SignsOffWhoHasEndedAndNobodyElse) {
  const fs::path dead = folder_.path() / "cleave_1_2";
  const fs::path alive = folder_.path() / "cleave_3_4";
  const fs::path foreign = folder_.path() / "somebody";
  { const test::ListeningSocket ended(dead), other(foreign); }
  const test::ListeningSocket runs(alive);
  RouDiWatch watch(RouDiWatch::Task::look_after, file());
  EXPECT_FALSE(look(watch));
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(alive));
  EXPECT_TRUE(fs::exists(foreign));
}

}  // namespace
}  // namespace cleave
