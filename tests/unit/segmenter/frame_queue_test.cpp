// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/frame_queue.hpp"

#include <gtest/gtest.h>

#include <future>
#include <optional>
#include <vector>

namespace cleave::service {
namespace {

using Queue = FrameQueue<int>;

int take(Queue& queue) {
  return queue.take()->frame;
}

TEST(FrameQueue, HandsOutFramesInTheOrderTheyCame) {
  Queue queue(Mode::live, 3, 8);
  for (const int frame : {1, 2, 3}) EXPECT_FALSE(queue.push(frame));

  EXPECT_EQ(take(queue), 1);
  EXPECT_EQ(take(queue), 2);
  EXPECT_EQ(take(queue), 3);
}

TEST(FrameQueue, LiveDropsTheOldestWaitingFrameWhenItIsFull) {
  Queue queue(Mode::live, 2, 8);
  (void)queue.push(1);
  (void)queue.push(2);

  EXPECT_EQ(queue.push(3), 1);
  EXPECT_EQ(queue.push(4), 2);
  EXPECT_EQ(take(queue), 3);
  EXPECT_EQ(take(queue), 4);
}

TEST(FrameQueue, LosslessWaitsForRoomAndDropsNothing) {
  Queue queue(Mode::lossless, 1, 8);
  auto pushed = std::async(std::launch::async, [&] {
    bool dropped = false;
    for (int frame = 0; frame < 100; ++frame) dropped |= queue.push(frame).has_value();
    return dropped;
  });

  for (int frame = 0; frame < 100; ++frame) EXPECT_EQ(take(queue), frame);
  EXPECT_FALSE(pushed.get());
}

TEST(FrameQueue, HandsOutNoMoreFramesThanThereArePlaces) {
  Queue queue(Mode::live, 4, 2);
  for (const int frame : {1, 2, 3}) (void)queue.push(frame);
  std::optional<Queue::Taken> first = queue.take();
  const std::optional<Queue::Taken> second = queue.take();
  auto third = std::async(std::launch::async, [&] { return take(queue); });

  EXPECT_EQ(third.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  first.reset();
  EXPECT_EQ(third.get(), 3);
}

TEST(FrameQueue, CloseStillHandsOutWhatWaits) {
  Queue queue(Mode::live, 2, 8);
  (void)queue.push(1);
  queue.close();

  EXPECT_EQ(take(queue), 1);
  EXPECT_FALSE(queue.take());
}

TEST(FrameQueue, CloseEndsEveryThreadThatWaits) {
  Queue queue(Mode::live, 2, 8);
  std::vector<std::future<bool>> waiting;
  for (int i = 0; i < 3; ++i) {
    waiting.push_back(std::async(std::launch::async, [&] { return queue.take().has_value(); }));
  }

  queue.close();

  for (std::future<bool>& thread : waiting) EXPECT_FALSE(thread.get());
}

TEST(FrameQueue, CloseEndsThreadsThatWaitForAPlaceOnceAllFramesAreDone) {
  Queue queue(Mode::live, 2, 1);
  (void)queue.push(1);
  (void)queue.push(2);
  std::optional<Queue::Taken> first = queue.take();
  std::vector<std::future<int>> waiting;
  for (int i = 0; i < 3; ++i) {
    waiting.push_back(std::async(std::launch::async, [&] {
      int taken = 0;
      while (queue.take()) ++taken;
      return taken;
    }));
  }

  queue.close();
  first.reset();

  int taken = 0;
  for (std::future<int>& thread : waiting) taken += thread.get();
  EXPECT_EQ(taken, 1);
}

}  // namespace
}  // namespace cleave::service
