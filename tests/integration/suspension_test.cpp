// SPDX-License-Identifier: BSD-3-Clause
// Processes that are suspended (a debugger, a laptop's lid, a virtual machine that pauses) go on by
// themselves, and nobody else suffers.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
#include <thread>
#include <vector>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/roudi_fixture.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

using std::chrono::milliseconds;

class Suspension : public testing::Test {
 protected:
  void SetUp() override {
    write_pcd(folder_.path() / "a.pcd", 80, 60);
    ASSERT_TRUE(segmenter_.logs("ready")) << segmenter_.log();
    grabber_.emplace(daemons_.grabber("pcd:" + folder_.path().string(), {"--loop"}));
    ASSERT_TRUE(segments_flow());
  }

  testing::AssertionResult segments_flow() {
    return monitor_.lists_flow(30)
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << segmenter_.log() << grabber_->log();
  }

  // Stops the processes for a while, lets them go on in the same order, and tells after how long a
  // segment list came.
  void suspend(const std::vector<pid_t>& processes, milliseconds duration) {
    for (const pid_t process : processes) ::kill(process, SIGSTOP);
    std::this_thread::sleep_for(duration);
    monitor_.poll();
    const std::size_t before = monitor_.lists().size();
    const auto resumed = std::chrono::steady_clock::now();
    for (const pid_t process : processes) ::kill(process, SIGCONT);
    ASSERT_TRUE(eventually([&] {
      monitor_.poll();
      return monitor_.lists().size() > before;
    })) << segmenter_.log()
        << grabber_->log();
    const std::chrono::duration<double> gap = std::chrono::steady_clock::now() - resumed;
    std::cout << "suspended for " << duration.count() << " ms: the next list " << gap.count()
              << " s after it\n";
    EXPECT_TRUE(segments_flow());
  }

  // Both daemons run, know that they do, and have lost account of nothing.
  void expect_all_is_well() {
    EXPECT_TRUE(segmenter_.running()) << segmenter_.log();
    EXPECT_TRUE(grabber_->running()) << grabber_->log();
    EXPECT_TRUE(eventually([&] {
      monitor_.poll();
      return monitor_.status("segmenter/camera").state == NodeState::running &&
             monitor_.status("grabber/camera").state == NodeState::running;
    })) << segmenter_.log();
    const NodeReport status = monitor_.status("segmenter/camera");
    EXPECT_EQ(status.transport_in_force, Transport::shared_memory);
    EXPECT_EQ(status.frames_in, status.frames_out + status.frames_dropped + status.frames_rejected +
                                    status.frames_in_flight);
    EXPECT_EQ(segmenter_.log().find("restarting"), std::string::npos) << segmenter_.log();
    EXPECT_EQ(grabber_->log().find("restarting"), std::string::npos) << grabber_->log();
  }

  TemporaryFolder folder_;
  const RouDi roudi_;
  Daemons daemons_{15, true};
  Monitor monitor_{15, "camera"};
  Process segmenter_ = daemons_.segmenter();
  std::optional<Process> grabber_;
};

TEST_F(Suspension, OfEachDaemonIsSurvived) {
  for (const milliseconds duration : {milliseconds(500), milliseconds(2000)}) {
    suspend({grabber_->id()}, duration);
    suspend({segmenter_.id()}, duration);
  }
  expect_all_is_well();
}

TEST_F(Suspension, OfAllProcessesIsSurvivedInWhateverOrderTheyGoOn) {
  suspend({grabber_->id(), roudi_.id(), segmenter_.id()}, milliseconds(3000));
  suspend({roudi_.id(), segmenter_.id(), grabber_->id()}, milliseconds(3000));
  expect_all_is_well();
}

TEST_F(Suspension, ForLongerThanTheLeasesIsSurvived) {
  suspend({grabber_->id(), segmenter_.id()}, milliseconds(11000));
  expect_all_is_well();
}

TEST_F(Suspension, OfAReaderCostsNobodyElseAFrame) {
  const auto record = [&](const std::string& name) {
    return daemons_.run("cleave", {"record", (folder_.path() / name).string(), "--sensor", "camera",
                                   "--duration", "2"});
  };
  Process suspended = record("a.mcap");
  ASSERT_TRUE(suspended.logs("recording")) << suspended.log();
  suspended.signal(SIGSTOP);
  std::this_thread::sleep_for(milliseconds(3000));
  Process later = record("b.mcap");
  EXPECT_EQ(later.wait(), 0) << later.log();
  EXPECT_NE(later.output().find("labels"), std::string::npos) << later.output();
  EXPECT_EQ(later.output().find("labels 0"), std::string::npos) << later.output();
  Process status = daemons_.run("cleave", {"status"});
  EXPECT_EQ(status.wait(), 0) << status.log();
  suspended.signal(SIGCONT);
  EXPECT_EQ(suspended.wait(), 0) << suspended.log();
  expect_all_is_well();
  EXPECT_FALSE(monitor_.status("segmenter/camera").dropped_by_cause.contains("no label memory"));
}

}  // namespace
}  // namespace cleave::test
