// SPDX-License-Identifier: BSD-3-Clause
// tests/unit/c/frames_test.cpp reads whole frames; here is what C cannot ask for.
#include "libcleave/frames/frame_reader.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/unit/libcleave/test_stream.hpp"

namespace cleave {
namespace {

class FramesOfNobody : public testing::Test {
 protected:
  Stream stream_{test::network_options()};
  FrameReader frames_{stream_, test::sensor_name()};
};

TEST_F(FramesOfNobody, CanBeWokenFromAnotherThread) {
  std::thread waker([this] { frames_.wake(); });
  EXPECT_FALSE(frames_.next(std::chrono::milliseconds(-1)));
  waker.join();
  frames_.wake();
  EXPECT_FALSE(frames_.next(std::chrono::milliseconds(-1))) << "a wake before the wait is not lost";
}

TEST_F(FramesOfNobody, TellThatNobodyIsThere) {
  EXPECT_FALSE(frames_.next(std::chrono::milliseconds(1)));
  EXPECT_EQ(frames_.live_sensors(), 0U);
  EXPECT_EQ(frames_.live_segmenters(), 0U);
}

}  // namespace
}  // namespace cleave
