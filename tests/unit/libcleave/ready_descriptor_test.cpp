// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/ready_descriptor.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <csignal>
#include <optional>
#include <thread>
#include <utility>

#include "libcleave/cloud_reader.hpp"
#include "libcleave/cloud_writer.hpp"
#include "libcleave/writer.hpp"
#include "tests/unit/libcleave/test_stream.hpp"

namespace cleave {
namespace {

using std::chrono::milliseconds;

class ReadyReaders : public testing::Test {
 protected:
  Stream stream_{test::network_options()};
  std::string sensor_ = test::sensor_name();
  ReadyDescriptor ready_;
};

TEST_F(ReadyReaders, MakeTheDescriptorReadableUntilNothingWaits) {
  Writer<SegmentList> writer(stream_, sensor_);
  Reader<SegmentList> reader(stream_, sensor_);
  ready_.attach(reader);
  const auto take = [&] { return ready_.take([&] { return reader.take(); }); };
  ASSERT_TRUE(ready_.wait(milliseconds(0))) << "a sample may wait already";
  EXPECT_FALSE(take());
  EXPECT_FALSE(ready_.wait(milliseconds(0)));
  ASSERT_TRUE(test::eventually([&] { return writer.matched_readers() == 1; }));
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(writer.publish(SegmentList{}));
    ASSERT_TRUE(writer.publish(SegmentList{}));
    ASSERT_TRUE(ready_.wait(std::chrono::seconds(10)));
    ASSERT_TRUE(test::eventually([&] { return take().has_value(); }));
    ASSERT_TRUE(test::eventually([&] { return take().has_value(); }));
    EXPECT_FALSE(take());
    EXPECT_FALSE(ready_.wait(milliseconds(0)));
  }
}

TEST_F(ReadyReaders, OfSmallAndLargeCloudsShareADescriptor) {
  CloudWriter writer(stream_, sensor_);
  CloudReader reader(stream_, sensor_);
  ready_.attach(reader);
  ASSERT_TRUE(test::eventually([&] { return writer.matched_readers() == 1; }));
  for (const std::uint64_t points : {std::uint64_t{8}, std::uint64_t{capacity_points}}) {
    EXPECT_FALSE(ready_.take([&] { return reader.take(); }));
    auto loan = writer.loan(points);
    ASSERT_TRUE(loan);
    loan->header() = FrameHeader{};
    ASSERT_TRUE(std::move(*loan).publish());
    ASSERT_TRUE(ready_.wait(std::chrono::seconds(10)));
    ASSERT_TRUE(ready_.take([&] { return reader.take(); }));
  }
}

// What comes between the two looks of take() must be told.
TEST_F(ReadyReaders, TellOfWhatCameWhileTheDescriptorWasDrained) {
  int left = 2;
  bool first_look = true;
  const auto take = [&]() -> std::optional<int> {
    if (std::exchange(first_look, false)) return std::nullopt;
    return left > 0 ? std::optional(left--) : std::nullopt;
  };
  EXPECT_EQ(ready_.take(take), 2);
  EXPECT_TRUE(ready_.wait(milliseconds(0)));
  EXPECT_EQ(ready_.take(take), 1);
  EXPECT_EQ(ready_.take(take), std::nullopt);
  EXPECT_FALSE(ready_.wait(milliseconds(0)));
}

TEST_F(ReadyReaders, StopWaitingWhenASignalsHandlerRan) {
  struct sigaction action {};
  action.sa_handler = [](int) {};
  struct sigaction before {};
  ASSERT_EQ(::sigaction(SIGUSR1, &action, &before), 0);
  const pthread_t waiting = ::pthread_self();
  std::atomic<bool> over = false;
  std::thread signaller([&] {
    while (!over) {
      ::pthread_kill(waiting, SIGUSR1);
      std::this_thread::sleep_for(milliseconds(5));
    }
  });
  EXPECT_FALSE(ready_.wait(milliseconds(-1)));
  over = true;
  signaller.join();
  ::sigaction(SIGUSR1, &before, nullptr);
}

}  // namespace
}  // namespace cleave
