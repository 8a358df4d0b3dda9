// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ahead_queue.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace cleave::recording {
namespace {

using std::chrono_literals::operator""ms;
using Result = AheadQueue<int>::Result;

constexpr std::chrono::seconds long_enough{20};

TEST(AheadQueue, HandsOutWhatWasPutInItsOrderAndThenSaysThatItEnded) {
  AheadQueue<int> queue(2);
  std::thread maker([&queue] {
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(queue.put(i));
    queue.end();
  });
  int item = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(queue.take(long_enough, item), Result::item);
    EXPECT_EQ(item, i);
  }
  EXPECT_EQ(queue.take(long_enough, item), Result::end);
  maker.join();
}

TEST(AheadQueue, SaysThatNothingCameInTime) {
  AheadQueue<int> queue(1);
  int item = 7;
  EXPECT_EQ(queue.take(1ms, item), Result::timeout);
  EXPECT_EQ(item, 7);
}

TEST(AheadQueue, StillHandsOutWhatWaitedWhenItEnded) {
  AheadQueue<int> queue(1);
  ASSERT_TRUE(queue.put(1));
  queue.end();
  EXPECT_TRUE(queue.wait_for_one());
  int item = 0;
  EXPECT_EQ(queue.take(0ms, item), Result::item);
  EXPECT_FALSE(queue.wait_for_one());
  EXPECT_EQ(queue.take(0ms, item), Result::end);
}

TEST(AheadQueue, LetsAMakerThatWaitsForRoomGoWhenItIsStopped) {
  AheadQueue<int> queue(1);
  bool taken = true;
  std::thread maker([&] {
    while (queue.put(0)) {
    }
    taken = queue.put(1);
  });
  EXPECT_TRUE(queue.wait_for_one());
  queue.stop();
  maker.join();
  EXPECT_FALSE(taken);
}

}  // namespace
}  // namespace cleave::recording
