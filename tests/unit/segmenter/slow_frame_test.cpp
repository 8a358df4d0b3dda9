// SPDX-License-Identifier: BSD-3-Clause
// The pipeline while one frame takes its time: resends, clouds that are let go, loans that run out.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/unit/segmenter/pipeline_fixture.hpp"

namespace cleave::service {
namespace {

using namespace test;

// Holds frame 1 in its worker until the test opens the gate.
class Gate {
 public:
  SegmentFunction worker() {
    return [this](const CloudView& view, std::span<std::uint16_t> labels, Segmentation& result) {
      if (view.point(0)[0] == 1) {
        entered_ = true;
        while (!open_) std::this_thread::yield();
      }
      return echo(view, labels, result);
    };
  }
  void wait_until_entered() const {
    while (!entered_) std::this_thread::yield();
  }
  void open() { open_ = true; }

 private:
  std::atomic<bool> open_{false};
  std::atomic<bool> entered_{false};
};

TEST(SlowFrame, IgnoresAResendInFlightAndAnswersOneThatWasPublished) {
  FakeSink sink;
  Gate gate;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, {gate.worker()});

  pipeline.accept(received(cloud(1), false));
  gate.wait_until_entered();
  pipeline.accept(received(cloud(1), false));
  gate.open();
  while (pipeline.counts().in_flight > 0) std::this_thread::yield();
  pipeline.accept(received(cloud(1), false));
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 1}));
  EXPECT_EQ(pipeline.counts().received, 1U);
  EXPECT_EQ(pipeline.counts().published, 1U);
  EXPECT_EQ(pipeline.counts().duplicates, 2U);
}

TEST(SlowFrame, LetsGoOfTheCloudBeforeItsTurnToBePublishedComes) {
  FakeSink sink;
  Gate gate;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, {gate.worker(), gate.worker()});
  pipeline.accept(received(cloud(1), false));
  gate.wait_until_entered();
  auto second = cloud(2);
  const std::weak_ptr<const DepthCloud> watched = second;
  pipeline.accept(received(std::move(second), false));

  while (!watched.expired()) std::this_thread::yield();
  EXPECT_TRUE(sink.lists.empty());
  gate.open();
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 2}));
}

TEST(SlowFrame, HoldsNoMoreLoansThanAWriterHasWhileASlowFrameBlocksTheOrder) {
  FakeSink sink;
  Gate gate;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink,
                         {gate.worker(), gate.worker(), gate.worker()});
  for (std::uint64_t id = 1; id <= 16; ++id) pipeline.accept(received(cloud(id), false));
  while (sink.loans < static_cast<int>(ResultSink::max_loans)) std::this_thread::yield();

  gate.open();
  pipeline.drain();

  EXPECT_EQ(sink.most_loans, static_cast<int>(ResultSink::max_loans));
  EXPECT_EQ(sink.lists.size(), 16U);
}

}  // namespace
}  // namespace cleave::service
