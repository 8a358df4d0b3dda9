// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/lossless_window.hpp"

#include <gtest/gtest.h>

namespace cleave {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class Window : public testing::Test {
 protected:
  Window() { window_.update(now_, 1); }
  static FrameKey frame(std::uint64_t id) { return {7, id}; }
  void publish(std::uint64_t id) {
    ASSERT_TRUE(window_.has_room());
    window_.published(frame(id), now_);
  }
  void wait(milliseconds time, unsigned segmenters = 1) {
    now_ += time;
    window_.update(now_, segmenters);
  }
  // One frame out and back, so that the window is open.
  void open() {
    publish(1);
    window_.returned(frame(1), now_);
  }

  LosslessWindow::Clock::time_point now_ = LosslessWindow::Clock::time_point() + seconds(1000);
  LosslessWindow window_{4};
};

TEST_F(Window, LetsOneFrameOutUntilAFirstListIsBack) {
  publish(1);
  EXPECT_FALSE(window_.has_room());
  window_.returned(frame(1), now_);
  EXPECT_TRUE(window_.has_room());
}

TEST_F(Window, LetsAsManyOutAsItIsWide) {
  open();
  for (std::uint64_t id = 2; id <= 5; ++id) publish(id);
  EXPECT_FALSE(window_.has_room());
  EXPECT_EQ(window_.in_flight(), 4U);
  window_.returned(frame(2), now_);
  EXPECT_TRUE(window_.has_room());
}

TEST_F(Window, TakesListsInAnyOrder) {
  open();
  for (std::uint64_t id = 2; id <= 5; ++id) publish(id);
  window_.returned(frame(4), now_);
  window_.returned(frame(2), now_);
  EXPECT_TRUE(window_.contains(frame(3)));
  EXPECT_FALSE(window_.contains(frame(4)));
  EXPECT_EQ(window_.in_flight(), 2U);
}

TEST_F(Window, IgnoresListsOfOtherFramesAndEpochs) {
  publish(1);
  window_.returned({6, 1}, now_);
  window_.returned(frame(2), now_);
  EXPECT_EQ(window_.in_flight(), 1U);
  EXPECT_FALSE(window_.has_room());
}

TEST_F(Window, PublishesAgainInOrderAfterTwoSecondsWithoutAList) {
  open();
  for (std::uint64_t id = 2; id <= 4; ++id) publish(id);
  wait(milliseconds(1999));
  EXPECT_FALSE(window_.to_resend());
  wait(milliseconds(1));
  EXPECT_FALSE(window_.has_room());
  ASSERT_EQ(window_.to_resend(), frame(2));
  window_.published(frame(2), now_);
  EXPECT_FALSE(window_.to_resend()) << "one at a time until a list is back";
  window_.returned(frame(2), now_);
  ASSERT_EQ(window_.to_resend(), frame(3));
  window_.published(frame(3), now_);
  ASSERT_EQ(window_.to_resend(), frame(4));
  window_.published(frame(4), now_);
  EXPECT_FALSE(window_.to_resend());
  EXPECT_TRUE(window_.has_room());
}

TEST_F(Window, CountsTheTwoSecondsFromTheLastListThatCameBack) {
  open();
  publish(2);
  publish(3);
  wait(milliseconds(1500));
  window_.returned(frame(2), now_);
  wait(milliseconds(1500));
  EXPECT_FALSE(window_.to_resend());
  wait(milliseconds(500));
  EXPECT_EQ(window_.to_resend(), frame(3));
}

TEST_F(Window, CountsTheTwoSecondsFromThePublicationAfterAPause) {
  open();
  wait(seconds(100));
  publish(2);
  wait(milliseconds(1999));
  EXPECT_FALSE(window_.to_resend());
}

TEST_F(Window, HasMorePatienceWithASegmenterThatIsSlow) {
  publish(1);
  wait(seconds(2));
  ASSERT_EQ(window_.to_resend(), frame(1));
  window_.published(frame(1), now_);
  wait(milliseconds(3999));
  EXPECT_FALSE(window_.to_resend());
  wait(milliseconds(1));
  EXPECT_TRUE(window_.to_resend());
}

TEST_F(Window, PublishesNothingAgainWhileNoSegmenterIsThere) {
  open();
  publish(2);
  wait(seconds(100), 0);
  EXPECT_FALSE(window_.to_resend());
}

TEST_F(Window, PublishesAllAgainAsSoonAsANewSegmenterIsThere) {
  open();
  publish(2);
  publish(3);
  wait(milliseconds(10), 0);
  wait(milliseconds(10), 1);
  EXPECT_EQ(window_.to_resend(), frame(2));
  EXPECT_FALSE(window_.has_room());
}

TEST_F(Window, TakesALateListOfAFrameThatWaitsToBePublishedAgain) {
  open();
  publish(2);
  publish(3);
  wait(seconds(2));
  window_.returned(frame(2), now_);
  EXPECT_EQ(window_.to_resend(), frame(3));
}

TEST_F(Window, OfOneFrameSendsFrameByFrame) {
  LosslessWindow narrow(1);
  narrow.update(now_, 1);
  narrow.published(frame(1), now_);
  EXPECT_FALSE(narrow.has_room());
  narrow.returned(frame(1), now_);
  narrow.published(frame(2), now_);
  EXPECT_FALSE(narrow.has_room());
}

}  // namespace
}  // namespace cleave
