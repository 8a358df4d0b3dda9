// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/watch/frame_account.hpp"

#include <gtest/gtest.h>

#include "reports.hpp"

namespace cleave::client {
namespace {

using std::chrono_literals::operator""ms;

class FrameAccountTest : public testing::Test {
 protected:
  FrameAccount account_{"camera"};
  SteadyTime now_{std::chrono::hours(1)};

  void tell(const NodeReport& report) { account_.add_report(report, now_); }
  void expect_invariant() {
    const Account a = account_.account(now_);
    EXPECT_EQ(a.published, a.segmented + a.dropped + a.rejected);
    EXPECT_EQ(a.dropped, sum_of(a.dropped_by_cause));
    EXPECT_EQ(a.rejected, sum_of(a.rejected_by_cause));
  }
};

TEST_F(FrameAccountTest, IsCompleteWhenAnEndedSourcesFramesAreAllAnswered) {
  tell(grabber(NodeState::ended, 45));
  tell(segmenter({.out = 44, .rejected = 1}));
  now_ += 300ms;
  EXPECT_TRUE(account_.complete(now_));
  const Account a = account_.account(now_);
  EXPECT_EQ(a.published, 45U);
  EXPECT_EQ(a.segmented, 44U);
  EXPECT_EQ(a.dropped, 0U);
  EXPECT_EQ(a.rejected, 1U);
  expect_invariant();
}

TEST_F(FrameAccountTest, WaitsAMomentForTheLastSegmentLists) {
  tell(grabber(NodeState::ended, 45));
  tell(segmenter({.out = 45}));
  EXPECT_FALSE(account_.complete(now_));
  now_ += 150ms;
  account_.add_segment_list(now_);
  now_ += 150ms;
  EXPECT_FALSE(account_.complete(now_));
  now_ += 60ms;
  EXPECT_TRUE(account_.complete(now_));
}

TEST_F(FrameAccountTest, IsNotCompleteBeforeTheSourceHasEnded) {
  tell(grabber(NodeState::running, 45));
  tell(segmenter({.out = 45}));
  now_ += 10000ms;
  EXPECT_FALSE(account_.complete(now_));
  expect_invariant();
}

TEST_F(FrameAccountTest, IsNotCompleteWhileFramesAreInFlight) {
  tell(grabber(NodeState::ended, 45));
  tell(segmenter({.out = 43, .in_flight = 2}));
  now_ += 10000ms;
  tell(segmenter({.out = 43, .in_flight = 2}));
  EXPECT_FALSE(account_.complete(now_));
  EXPECT_EQ(account_.account(now_).published, 43U) << "the fate of two is not known";
  expect_invariant();
}

TEST_F(FrameAccountTest, CountsFramesThatTheSegmenterNeverSawAfterAQuietSecond) {
  tell(grabber(NodeState::ended, 45));
  tell(segmenter({.out = 40, .dropped = 2}));
  now_ += 900ms;
  tell(segmenter({.out = 40, .dropped = 2}));
  EXPECT_FALSE(account_.complete(now_));
  now_ += 200ms;
  EXPECT_TRUE(account_.complete(now_));
  const Account a = account_.account(now_);
  EXPECT_EQ(a.published, 45U);
  EXPECT_EQ(a.dropped, 5U);
  EXPECT_EQ(a.dropped_by_cause.at("transport"), 3U);
  EXPECT_EQ(a.dropped_by_cause.at("queue"), 2U);
  expect_invariant();
}

TEST_F(FrameAccountTest, BelievesNoSilenceThatTheSegmenterDidNotConfirm) {
  tell(grabber(NodeState::ended, 45));
  tell(segmenter({.out = 40}));
  now_ += 5000ms;
  EXPECT_FALSE(account_.complete(now_)) << "the status may be older than the last frames";
}

TEST_F(FrameAccountTest, StaysCompleteWhenTheEndedGrabberLeaves) {
  tell(grabber(NodeState::ended, 45));
  tell(grabber(NodeState::stopping, 45));
  tell(segmenter({.out = 45}));
  now_ += 300ms;
  EXPECT_TRUE(account_.complete(now_));
  tell(grabber(NodeState::running, 45));
  now_ += 300ms;
  EXPECT_FALSE(account_.complete(now_)) << "a new run has begun";
}

TEST_F(FrameAccountTest, AddsUpProcessesThatWereStartedAgain) {
  NodeReport first = grabber(NodeState::running, 10);
  first.process_id = 1;
  NodeReport second = grabber(NodeState::ended, 5);
  second.process_id = 2;
  tell(first);
  tell(second);
  NodeReport early = segmenter({.out = 10});
  early.process_id = 3;
  NodeReport late = segmenter({.out = 4, .rejected = 1});
  late.process_id = 4;
  tell(early);
  tell(late);
  now_ += 300ms;
  EXPECT_TRUE(account_.complete(now_));
  EXPECT_EQ(account_.account(now_).published, 15U);
  EXPECT_EQ(account_.account(now_).segmented, 14U);
  expect_invariant();
}

TEST_F(FrameAccountTest, KeepsTheInvariantWhenTheSegmenterSawMoreThanThisGrabberPublished) {
  tell(grabber(NodeState::ended, 45));
  tell(segmenter({.out = 145}));
  now_ += 300ms;
  EXPECT_EQ(account_.account(now_).published, 145U);
  expect_invariant();
}

TEST_F(FrameAccountTest, IsCompleteWithoutAFrameAtAll) {
  tell(grabber(NodeState::ended, 0));
  now_ += 300ms;
  EXPECT_TRUE(account_.complete(now_));
  expect_invariant();
}

TEST_F(FrameAccountTest, HeedsItsOwnSensorOnly) {
  NodeReport other = grabber(NodeState::ended, 45);
  other.node = "grabber/other";
  tell(other);
  EXPECT_FALSE(account_.grabber().has_value());
  now_ += 10000ms;
  EXPECT_FALSE(account_.complete(now_));
}

TEST_F(FrameAccountTest, SaysZeroCopyWhenEveryCloudThatCameWasHandedOver) {
  EXPECT_FALSE(account_.zero_copy()) << "before the first cloud";
  NodeReport report = segmenter({.out = 40, .dropped = 2, .in_flight = 1});
  report.frames_zero_copy = 43;
  tell(report);
  EXPECT_TRUE(account_.zero_copy());
  report.frames_zero_copy = 42;
  tell(report);
  EXPECT_FALSE(account_.zero_copy());
  report.frames_in += 3;
  report.frames_dropped += 3;
  report.dropped_by_cause["transport"] = 3;
  report.frames_zero_copy = 43;
  tell(report);
  EXPECT_TRUE(account_.zero_copy()) << "what was lost in transport was handed over to nobody";
}

}  // namespace
}  // namespace cleave::client
