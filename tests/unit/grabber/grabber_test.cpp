// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/grabber.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <future>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "tests/unit/grabber/scripted_source.hpp"

namespace cleave::sensor {
namespace {

using Event = ScriptedSource::Event;
using std::chrono::milliseconds;
constexpr char sensor[] = "test";

struct Received {
  std::uint32_t epoch;
  std::uint64_t id;
  float x;
  bool operator==(const Received&) const = default;
};

// A grabber on a thread of its own, and what a segmenter and a status client see of it.
class GrabberLoop : public testing::Test {
 protected:
  std::future<Ending> start(std::optional<std::uint32_t> window = {},
                            std::optional<std::uint64_t> frames = {}) {
    GrabberOptions options;
    options.sensor = sensor;
    options.coordinate_frame = "test_optical";
    options.parent_frame = "robot";
    options.pose = {{1, 2, 3}, {0, 0, 0, 1}};
    options.fps = 240;
    options.window = window;
    options.max_frames = frames;
    return std::async(std::launch::async, [this, options] {
      Grabber grabber(options, stream_, *source_, shutdown_);
      return grabber.run();
    });
  }
  void be_segmenter() {
    if (lists_ == nullptr) lists_ = std::make_unique<Writer<SegmentList>>(stream_, sensor);
    if (clouds_ == nullptr) {
      clouds_ = std::make_unique<Reader<DepthCloud>>(stream_, sensor, ReaderDepth{16});
    }
  }
  void answer(const Received& frame) {
    SegmentList list{};
    list.header.epoch = frame.epoch;
    list.header.frame_id = frame.id;
    ASSERT_TRUE(lists_->publish(list));
  }
  // Takes clouds until `enough`, or the grabber is done; what `answers` says is answered.
  std::vector<Received> receive(
      std::future<Ending>& grabber, std::size_t enough,
      const std::function<bool(const Received&)>& answers = [](const Received&) { return true; }) {
    std::vector<Received> received;
    while (received.size() < enough &&
           grabber.wait_for(milliseconds(1)) != std::future_status::ready) {
      while (const auto cloud = clouds_->take()) {
        const FrameHeader& header = (*cloud)->header;
        received.push_back({header.epoch, header.frame_id, (*cloud)->xyz[0]});
        if (answers(received.back())) answer(received.back());
      }
    }
    return received;
  }
  NodeReport last_status() {
    NodeReport report;
    while (const auto status = statuses_.take()) report = report_of(**status);
    return report;
  }
  // Statuses that come in, until one satisfies; the test's time-out is the only limit.
  NodeReport wait_for_status(const std::function<bool(const NodeReport&)>& satisfies) {
    for (;;) {
      while (const auto status = statuses_.take()) {
        NodeReport report = report_of(**status);
        if (satisfies(report)) return report;
      }
      std::this_thread::sleep_for(milliseconds(1));
    }
  }
  void script(const std::vector<Event>& events, bool realtime = false) {
    source_ = std::make_unique<ScriptedSource>(events, realtime);
  }

  Shutdown shutdown_;
  Stream stream_{StreamOptions{40, false, "lo"}};
  Reader<NodeStatus> statuses_{stream_, "", ReaderDepth{64}};
  std::unique_ptr<ScriptedSource> source_;
  std::unique_ptr<Writer<SegmentList>> lists_;
  std::unique_ptr<Reader<DepthCloud>> clouds_;
};

TEST_F(GrabberLoop, EndsWithFailureWhenTheSourceCannotBeOpened) {
  script({});
  source_->failures_to_open = 1;
  EXPECT_EQ(start().get(), Ending::failed);
  EXPECT_EQ(last_status().last_error, "nothing is plugged in");
}

TEST_F(GrabberLoop, PublishesARecordingOnceAReaderIsThereAndEnds) {
  script(std::vector<Event>(5, Event::frame));
  auto grabber = start();
  (void)wait_for_status([](const NodeReport& r) { return r.state == NodeState::running; });
  be_segmenter();
  const auto received = receive(grabber, 5);
  EXPECT_EQ(grabber.get(), Ending::done);
  ASSERT_EQ(received.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(received[i].id, i + 1);
    EXPECT_EQ(received[i].x, static_cast<float>(i + 1));
  }
  const NodeReport status = last_status();
  EXPECT_EQ(status.state, NodeState::ended);
  EXPECT_EQ(status.frames_in, 5U);
  EXPECT_EQ(status.frames_out, 5U);
}

TEST_F(GrabberLoop, DropsAndCountsTheFramesOfACameraThatNobodyWatches) {
  script(std::vector<Event>(7, Event::frame), true);
  EXPECT_EQ(start().get(), Ending::done);
  const NodeReport status = last_status();
  EXPECT_EQ(status.frames_in, 7U);
  EXPECT_EQ(status.frames_out, 0U);
  EXPECT_EQ(status.dropped_by_cause.at("no reader"), 7U);
}

TEST_F(GrabberLoop, NeverWritesMorePointsThanACloudHoldsWhateverTheSourceHas) {
  for (const std::optional<std::uint32_t> window : {std::optional<std::uint32_t>{}, {4U}}) {
    script({Event::frame, Event::frame_too_large, Event::frame});
    be_segmenter();
    auto grabber = start(window);
    EXPECT_EQ(receive(grabber, 2).size(), 2U);
    EXPECT_EQ(grabber.get(), Ending::done);
    const NodeReport status = last_status();
    EXPECT_EQ(status.frames_in, 3U);
    EXPECT_EQ(status.dropped_by_cause.at("too many points"), 1U);
  }
}

TEST_F(GrabberLoop, EndsAfterAsManyFramesAsItWasAskedFor) {
  script(std::vector<Event>(100, Event::frame));
  be_segmenter();
  auto grabber = start({}, 3);
  EXPECT_EQ(receive(grabber, 100).size(), 3U);
  EXPECT_EQ(grabber.get(), Ending::done);
}

TEST_F(GrabberLoop, BeginsAnEpochWhenTheSourceDoesAndGoesOnNumbering) {
  script({Event::frame, Event::frame_of_new_epoch});
  be_segmenter();
  auto grabber = start(4);
  const auto received = receive(grabber, 2);
  EXPECT_EQ(grabber.get(), Ending::done);
  ASSERT_EQ(received.size(), 2U);
  EXPECT_EQ(received[1].epoch, received[0].epoch + 1);
  EXPECT_EQ(received[1].id, 2U);
}

TEST_F(GrabberLoop, ReopensALostSourceAndBeginsAnEpoch) {
  script({Event::frame, Event::lost, Event::frame});
  be_segmenter();
  auto grabber = start(4);
  auto received = receive(grabber, 1);
  const NodeReport lost =
      wait_for_status([](const NodeReport& r) { return r.state == NodeState::source_lost; });
  EXPECT_EQ(lost.last_error, "the cable was pulled");
  const auto more = receive(grabber, 1);
  EXPECT_EQ(grabber.get(), Ending::done);
  ASSERT_EQ(more.size(), 1U);
  EXPECT_EQ(more[0].epoch, received[0].epoch + 1);
  EXPECT_EQ(source_->opened, 2);
  EXPECT_EQ(last_status().last_error, "");
}

TEST_F(GrabberLoop, WaitsForASourceThatSomebodyElseHas) {
  script({Event::frame});
  source_->failures_to_open = 2;
  source_->taken = true;
  be_segmenter();
  auto grabber = start(4);
  const NodeReport waiting =
      wait_for_status([](const NodeReport& r) { return r.state == NodeState::source_lost; });
  EXPECT_EQ(waiting.last_error, "nothing is plugged in");
  EXPECT_EQ(receive(grabber, 1).size(), 1U);
  EXPECT_EQ(grabber.get(), Ending::done);
  const NodeReport status = last_status();
  EXPECT_EQ(status.last_error, "");
  EXPECT_EQ(status.interruptions, 1U);
}

TEST_F(GrabberLoop, ASourceThatOpensAndSendsNothingIsStillLost) {
  script({Event::lost, Event::lost, Event::frame}, true);
  be_segmenter();
  auto grabber = start();
  EXPECT_EQ(receive(grabber, 1).size(), 1U);
  EXPECT_EQ(grabber.get(), Ending::done);
  std::vector<NodeState> states;
  while (const auto status = statuses_.take()) {
    const NodeReport report = report_of(**status);
    if (states.empty() || states.back() != report.state) states.push_back(report.state);
    EXPECT_EQ(report.state == NodeState::source_lost, !report.last_error.empty());
  }
  EXPECT_EQ(std::count(states.begin(), states.end(), NodeState::source_lost), 1);
  EXPECT_EQ(source_->opened, 3);
}

TEST_F(GrabberLoop, LosslessDeliversEveryFrameThoughASegmenterLosesSome) {
  script(std::vector<Event>(12, Event::frame));
  be_segmenter();
  auto grabber = start(4);
  std::set<std::uint64_t> lost = {1, 5, 6};
  const auto received =
      receive(grabber, 1000, [&](const Received& frame) { return lost.erase(frame.id) == 0; });
  EXPECT_EQ(grabber.get(), Ending::done);
  std::set<std::uint64_t> ids;
  for (const Received& frame : received) {
    ids.insert(frame.id);
    EXPECT_EQ(frame.x, static_cast<float>(frame.id)) << "a frame came again with other points";
  }
  EXPECT_EQ(ids.size(), 12U);
  EXPECT_EQ(received.size(), 12U + 3U);
}

TEST_F(GrabberLoop, LosslessWaitsWithMoreThanItsWindowUnanswered) {
  script(std::vector<Event>(12, Event::frame));
  be_segmenter();
  auto grabber = start(2);
  const auto received = receive(grabber, 3, [](const Received& frame) { return frame.id == 1; });
  ASSERT_EQ(received.size(), 3U);
  EXPECT_EQ(received[2].id, 3U);
  const NodeReport status = wait_for_status([](const NodeReport& r) { return r.frames_out == 3; });
  EXPECT_EQ(status.frames_in_flight, 2U);
  shutdown_.request();
  EXPECT_EQ(grabber.get(), Ending::done);
}

TEST_F(GrabberLoop, EndsSoonWhenItIsAskedTo) {
  script({Event::frame}, true);
  source_->silent = true;
  auto grabber = start();
  (void)wait_for_status([](const NodeReport& r) { return r.state == NodeState::running; });
  shutdown_.request();
  EXPECT_EQ(grabber.get(), Ending::done);
  EXPECT_EQ(last_status().state, NodeState::stopping);
}

}  // namespace
}  // namespace cleave::sensor
