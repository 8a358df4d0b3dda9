// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/frame_book.hpp"

#include <gtest/gtest.h>

namespace cleave::sensor {
namespace {

using std::chrono::milliseconds;
const FrameBook::Clock::time_point start = FrameBook::Clock::time_point() + std::chrono::hours(1);

TEST(FrameBook, NumbersPublishedFramesFromOneAndLeavesNoGapForDroppedOnes) {
  FrameBook book(100);
  EXPECT_EQ(book.next(), (FrameKey{100, 1}));
  book.published(true, start);
  book.dropped("no free chunk");
  EXPECT_EQ(book.next(), (FrameKey{100, 2}));
}

TEST(FrameBook, GoesOnNumberingInANewEpoch) {
  FrameBook book(100);
  book.published(true, start);
  book.begin_epoch();
  EXPECT_EQ(book.next(), (FrameKey{101, 2}));
}

TEST(FrameBook, AccountsForEveryFrame) {
  FrameBook book(100);
  for (int i = 0; i < 5; ++i) book.published(i < 3, start);
  book.dropped("no reader");
  book.dropped("no reader");
  book.dropped("no free chunk");
  const SourceCounts source{4, {{"truncated", 2}}};
  NodeReport report;
  book.fill(report, source, start);
  EXPECT_EQ(report.frames_out, 5U);
  EXPECT_EQ(report.frames_zero_copy, 3U);
  EXPECT_EQ(report.frames_dropped, 7U);
  EXPECT_EQ(report.frames_rejected, 2U);
  EXPECT_EQ(report.frames_in, 14U);
  EXPECT_EQ(report.dropped_by_cause.at("no reader"), 2U);
  EXPECT_EQ(report.dropped_by_cause.at("sensor"), 4U);
  EXPECT_EQ(report.rejected_by_cause.at("truncated"), 2U);
}

TEST(FrameBook, CountsInterruptions) {
  FrameBook book(100);
  book.interrupted();
  book.interrupted();
  NodeReport report;
  book.fill(report, {}, start);
  EXPECT_EQ(report.interruptions, 2U);
}

TEST(FrameBook, TellsTheRateOfTheLastTwoSeconds) {
  FrameBook book(100);
  NodeReport report;
  book.fill(report, {}, start);
  EXPECT_EQ(report.rate_hz, 0);
  for (int i = 0; i < 100; ++i) book.published(true, start + milliseconds(50 * i));
  book.fill(report, {}, start + milliseconds(50 * 99));
  EXPECT_NEAR(report.rate_hz, 20, 0.01);
  book.fill(report, {}, start + milliseconds(50 * 99 + 2100));
  EXPECT_EQ(report.rate_hz, 0) << "it has stopped";
}

}  // namespace
}  // namespace cleave::sensor
