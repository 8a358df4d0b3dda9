// SPDX-License-Identifier: BSD-3-Clause
// A camera that fails in every way that cameras fail in, with the real processes and RouDi: the
// stream comes back by itself, and what became of every frame is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <optional>
#include <set>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

constexpr double fps = 10;  // a machine that is busy with other tests keeps up
constexpr char grabber_node[] = "grabber/camera";
constexpr char segmenter_node[] = "segmenter/camera";

class CameraFault : public testing::Test {
 protected:
  // A grabber of the synthetic camera with these faults, and a segmenter that is ready for it.
  void start(const std::string& faults) {
    segmenter_.emplace(daemons_.segmenter());
    ASSERT_TRUE(segmenter_->logs("ready")) << segmenter_->log();
    grabber_.emplace(daemons_.grabber("synthetic:simple?frames=1&fps=10&" + faults));
  }
  testing::AssertionResult wait_until(const std::function<bool()>& condition) {
    const bool happened = eventually([&] {
      monitor_.poll();
      return condition();
    });
    if (happened) return testing::AssertionSuccess();
    return testing::AssertionFailure() << grabber_->log() << segmenter_->log();
  }
  testing::AssertionResult epochs(std::size_t wanted, std::size_t frames_in_the_last = 8) {
    return wait_until([this, wanted, frames_in_the_last] {
      const auto count = std::count_if(lists().begin(), lists().end(), [this](const auto& list) {
        return list.epoch == lists().back().epoch;
      });
      return epochs_seen() == wanted && count >= static_cast<std::ptrdiff_t>(frames_in_the_last);
    });
  }
  [[nodiscard]] const std::vector<ListSummary>& lists() const { return monitor_.lists(); }
  [[nodiscard]] std::size_t epochs_seen() const {
    std::set<std::uint32_t> seen;
    for (const ListSummary& list : lists()) seen.insert(list.epoch);
    return seen.size();
  }
  // Between the last frame of an epoch and the first of the next.
  [[nodiscard]] double gap_s() const {
    for (std::size_t i = 1; i < lists().size(); ++i) {
      if (lists()[i].epoch == lists()[i - 1].epoch) continue;
      return static_cast<double>(lists()[i].capture_time_ns - lists()[i - 1].capture_time_ns) / 1e9;
    }
    return 0;
  }
  // Since the test began.
  [[nodiscard]] double run_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }
  [[nodiscard]] NodeReport grabber_status() const { return monitor_.status(grabber_node); }
  // The status was `state` with an error that holds `text`, and the last one has no error.
  void expect_told(NodeState state, const std::string& text) const {
    bool told = false;
    for (const NodeReport& report : monitor_.history(grabber_node)) {
      told = told || (report.state == state && report.last_error.find(text) != std::string::npos);
    }
    EXPECT_TRUE(told) << grabber_->log();
    EXPECT_EQ(grabber_status().state, NodeState::running);
    EXPECT_EQ(grabber_status().last_error, "");
  }

  // Ends the processes; then every frame is accounted for, from the device to the segment list.
  void expect_account() {
    grabber_->signal(SIGTERM);
    EXPECT_EQ(grabber_->wait(), 0) << grabber_->log();
    EXPECT_TRUE(wait_until([this] {
      return grabber_status().state == NodeState::stopping && segmenter_is_done() &&
             lists().size() >= monitor_.status(segmenter_node).frames_out;
    }));
    const NodeReport grabber = grabber_status();
    const NodeReport segmenter = monitor_.status(segmenter_node);
    EXPECT_EQ(grabber.frames_in, grabber.frames_out + grabber.frames_dropped +
                                     grabber.frames_rejected + grabber.frames_in_flight);
    EXPECT_EQ(segmenter.frames_in,
              segmenter.frames_out + segmenter.frames_dropped + segmenter.frames_rejected);
    std::set<std::uint64_t> ids;
    for (const ListSummary& list : lists()) EXPECT_TRUE(ids.insert(list.frame_id).second);
    EXPECT_EQ(ids.size(), segmenter.frames_out);
    EXPECT_LE(grabber.frames_out - segmenter.frames_in, 2U)
        << "only what the grabber's writer still held is lost with it";
    EXPECT_LE(*ids.rbegin() - ids.size(), segmenter.frames_in - segmenter.frames_out)
        << "an id that has no list was dropped by the segmenter";
    // Within an epoch, ticks of the device's clock without a list are frames that the grabber
    // counts as the sensor's drops or its own, or the segmenter as its own.
    EXPECT_LE(ticks_without_list(), count_of(grabber, "sensor") +
                                        count_of(grabber, "no free chunk") + grabber.frames_out -
                                        segmenter.frames_out);
  }
  // It has seen that the grabber is gone, and has counted nothing more since.
  [[nodiscard]] bool segmenter_is_done() const {
    const std::vector<NodeReport> reports = monitor_.history(segmenter_node);
    return reports.size() >= 2 && std::all_of(reports.end() - 2, reports.end(), [&](const auto& r) {
             return r.state == NodeState::source_lost && r.frames_in == reports.back().frames_in &&
                    r.frames_in_flight == 0;
           });
  }
  // The device's clock ticks once a frame.
  [[nodiscard]] std::uint64_t ticks_without_list() const {
    std::uint64_t missing = 0;
    for (std::size_t i = 1; i < lists().size(); ++i) {
      const ListSummary& before = lists()[i - 1];
      const ListSummary& list = lists()[i];
      if (list.epoch != before.epoch) continue;
      const auto passed_us = static_cast<double>(list.device_time_us - before.device_time_us);
      missing += static_cast<std::uint64_t>(std::llround(passed_us * fps / 1e6)) - 1;
    }
    return missing;
  }
  static std::uint64_t count_of(const NodeReport& report, const std::string& cause) {
    const auto found = report.dropped_by_cause.find(cause);
    return found == report.dropped_by_cause.end() ? 0 : found->second;
  }

  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  RouDi roudi_;
  Daemons daemons_{14, true};
  Monitor monitor_{14, "camera"};
  std::optional<Process> segmenter_;
  std::optional<Process> grabber_;
};

TEST_F(CameraFault, ACameraThatIsUnpluggedAndPluggedInAgainResumesByItself) {
  start("unplug_at_ms=2000&replug_after_ms=1000");
  ASSERT_TRUE(epochs(2));
  expect_told(NodeState::source_lost, "disconnected");
  EXPECT_EQ(grabber_status().interruptions, 1U);
  RecordProperty("resumed_after_s", std::to_string(gap_s() - 1));
  expect_account();
}

TEST_F(CameraFault, ACameraThatStallsForThreeSecondsResumesByItself) {
  start("stall_at_ms=2000&stall_ms=3000");
  ASSERT_TRUE(epochs(2));
  expect_told(NodeState::source_lost, "sent no frame for 800 ms");
  EXPECT_EQ(grabber_status().interruptions, 1U);
  RecordProperty("resumed_after_s", std::to_string(gap_s() - 3));
  expect_account();
}

TEST_F(CameraFault, ACameraThatIsInUseAtTheStartIsWaitedFor) {
  start("in_use_ms=2000");
  ASSERT_TRUE(wait_until([this] { return grabber_status().state == NodeState::source_lost; }));
  ASSERT_TRUE(epochs(1));
  expect_told(NodeState::source_lost, "the camera is in use");
  EXPECT_EQ(grabber_status().interruptions, 1U);
  expect_account();
}

TEST_F(CameraFault, ACameraWhoseClockIsResetBeginsAnEpochAndLosesNothing) {
  start("clock_reset_at_ms=2000");
  ASSERT_TRUE(epochs(2));
  EXPECT_EQ(grabber_status().interruptions, 1U);
  EXPECT_GE(gap_s(), 0) << "capture times go on across the reset";
  EXPECT_LT(gap_s(), run_s()) << "and do not leap";
  expect_account();
}

TEST_F(CameraFault, FramesThatTheCameraNumberedAndNobodyGotAreCountedAsTheSensors) {
  start("drop_at_ms=2000&drop_frames=4");  // half a second: more would be a stall
  ASSERT_TRUE(wait_until(
      [this] { return count_of(grabber_status(), "sensor") >= 4 && lists().size() > 20; }));
  EXPECT_EQ(grabber_status().interruptions, 0U);
  EXPECT_EQ(epochs_seen(), 1U);
  EXPECT_GE(ticks_without_list(), 4U);
  expect_account();
}

TEST_F(CameraFault, ASizeThatTheCameraLacksIsRefusedWithItsRange) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "grabber.yaml";
  std::ofstream(file) << "source: synthetic:simple?fps=10\nvideo: {width: 2000, height: 240}\n";
  Process grabber = daemons_.run("cleave-grabber", {"--config", file.string()});
  EXPECT_EQ(grabber.wait(), 1);
  EXPECT_NE(grabber.log().find("from 16 to 1600"), std::string::npos) << grabber.log();
}

}  // namespace
}  // namespace cleave::test
