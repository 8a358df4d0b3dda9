// SPDX-License-Identifier: BSD-3-Clause
// Live mode when frames come faster than they are done: what is published stays young. Time is
// counted in frames that came meanwhile, not in seconds.
#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "tests/unit/segmenter/pipeline_fixture.hpp"

namespace cleave::service {
namespace {

using namespace test;

// A worker that finishes a frame only when it is told to.
class SlowSegmenter {
 public:
  SegmentFunction worker() {
    return [this](const CloudView& view, std::span<std::uint16_t> labels, Segmentation& result) {
      std::unique_lock lock(mutex_);
      busy_with_ = static_cast<std::uint64_t>(view.point(0)[0]);
      changed_.notify_all();
      changed_.wait(lock, [this] { return permits_ > 0; });
      --permits_;
      busy_with_ = 0;
      return echo(view, labels, result);
    };
  }
  // The frame in the worker's hands, once it has one.
  std::uint64_t wait_until_busy() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return busy_with_ != 0; });
    return busy_with_;
  }
  void finish(int frames) {
    {
      const std::lock_guard lock(mutex_);
      permits_ += frames;
      busy_with_ = 0;
    }
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;  // guards the two below
  int permits_ = 0;
  std::uint64_t busy_with_ = 0;
  std::condition_variable changed_;
};

class BackPressure : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(QueueCapacities, BackPressure, testing::Values(1, 2, 8));

TEST_P(BackPressure, SegmentsNoFrameThatIsOlderThanTheQueueIsLongHoweverManyCome) {
  constexpr std::uint64_t frames_during_one = 10;
  constexpr std::uint64_t segmented = 20;
  const std::size_t capacity = GetParam();
  FakeSink sink;
  SlowSegmenter slow;
  FramePipeline pipeline({"camera", Mode::live, capacity}, sink, {slow.worker()});

  std::uint64_t newest = 0;
  pipeline.accept(received(cloud(++newest), true));
  (void)slow.wait_until_busy();
  for (std::uint64_t done = 0; done < segmented; ++done) {
    for (std::uint64_t i = 0; i < frames_during_one; ++i)
      pipeline.accept(received(cloud(++newest), true));
    expect_balanced(pipeline.counts());
    slow.finish(1);
    EXPECT_EQ(slow.wait_until_busy(), newest - capacity + 1) << "not the oldest that may wait";
  }
  slow.finish(static_cast<int>(capacity));
  pipeline.drain();

  EXPECT_EQ(sink.list_ids().back(), newest) << "the newest frame is always segmented";
  EXPECT_EQ(pipeline.counts().received, newest);
  EXPECT_EQ(pipeline.counts().published, segmented + capacity);
  EXPECT_EQ(pipeline.counts().dropped.at(static_cast<std::size_t>(DropCause::queue)),
            newest - segmented - capacity);
}

}  // namespace
}  // namespace cleave::service
