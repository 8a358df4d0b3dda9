// SPDX-License-Identifier: BSD-3-Clause
// Processes that come, go and die, on the network path.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

class Fault : public testing::Test {
 protected:
  Fault() { write_pcd(folder_.path() / "a.pcd", 80, 60); }

  Process grabber() { return daemons_.grabber("pcd:" + folder_.path().string(), {"--loop"}); }

  // At least `count` more lists than there were.
  testing::AssertionResult segments_flow(std::size_t count = 5) {
    return monitor_.lists_flow(count) ? testing::AssertionSuccess()
                                      : testing::AssertionFailure() << "no segments come";
  }

  bool segmenter_says(NodeState state) {
    return eventually([&] {
      monitor_.poll();
      return monitor_.status("segmenter/camera").state == state;
    });
  }

  TemporaryFolder folder_;
  Daemons daemons_{12, false};
  Monitor monitor_{12, "camera"};
};

TEST_F(Fault, ASegmenterMayStartBeforeTheGrabber) {
  Process segmenter = daemons_.segmenter();
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  const Process camera = grabber();
  EXPECT_TRUE(segments_flow()) << segmenter.log();
}

TEST_F(Fault, ASegmenterMayStartAfterTheGrabber) {
  Process camera = grabber();
  ASSERT_TRUE(camera.logs("waiting")) << camera.log();
  const Process segmenter = daemons_.segmenter();
  EXPECT_TRUE(segments_flow()) << camera.log();
}

TEST_F(Fault, AGrabberThatIsKilledIsReportedAsLostAndSegmentsFlowAgainWhenItIsBack) {
  Process segmenter = daemons_.segmenter();
  {
    Process camera = grabber();
    ASSERT_TRUE(segments_flow()) << camera.log();
    camera.signal(SIGKILL);
    EXPECT_EQ(camera.wait(), 128 + SIGKILL);
  }
  EXPECT_TRUE(segmenter_says(NodeState::source_lost)) << segmenter.log();
  const Process camera = grabber();
  EXPECT_TRUE(segments_flow()) << camera.log();
  EXPECT_TRUE(segmenter_says(NodeState::running));
}

TEST_F(Fault, ASegmenterThatIsKilledAndStartedAgainIsServedAgain) {
  const Process camera = grabber();
  {
    Process segmenter = daemons_.segmenter();
    ASSERT_TRUE(segments_flow()) << segmenter.log();
    segmenter.signal(SIGKILL);
    EXPECT_EQ(segmenter.wait(), 128 + SIGKILL);
  }
  const Process segmenter = daemons_.segmenter();
  EXPECT_TRUE(segments_flow()) << camera.log() << segmenter.log();
}

TEST_F(Fault, ASecondGrabberOfTheSameSensorSaysSoAndEndsWith1) {
  Process first = grabber();
  ASSERT_TRUE(first.logs("waiting")) << first.log();
  Process second = grabber();
  EXPECT_EQ(second.wait(), 1);
  EXPECT_NE(second.log().find("already"), std::string::npos) << second.log();
  EXPECT_NE(second.log().find(std::to_string(first.id())), std::string::npos) << second.log();
  EXPECT_TRUE(first.running());
}

TEST_F(Fault, SigtermDrainsAndEndsBothDaemonsWith0) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Process segmenter = daemons_.segmenter();
    Process camera = grabber();
    ASSERT_TRUE(segments_flow()) << camera.log();
    camera.signal(signal);
    EXPECT_EQ(camera.wait(), 0) << camera.log();
    segmenter.signal(signal);
    EXPECT_EQ(segmenter.wait(), 0) << segmenter.log();
  }
}

TEST_F(Fault, ASegmenterThatIsAskedToEndWhileItStartsDoesNotFinishStarting) {
  const std::filesystem::path file = folder_.path() / "many.yaml";
  std::ofstream text(file);
  text << "workers: 1\nsensors: [s0";
  for (int i = 1; i < 128; ++i) text << ", s" << i;
  text << "]\n" << std::flush;
  Process segmenter =
      daemons_.run("cleave-segmenter", {"--config", file.string(), "--no-shared-memory"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  segmenter.signal(SIGTERM);
  EXPECT_EQ(segmenter.wait(), 0) << segmenter.log();
  EXPECT_EQ(segmenter.log().find("'s127'"), std::string::npos);
}

TEST_F(Fault, ARecordingThatCannotBeIsRefusedAtOnce) {
  Process endless = daemons_.run("cleave", {"record", "a.mcap", "--duration", "nan"});
  EXPECT_EQ(endless.wait(), 2) << endless.log();
  EXPECT_NE(endless.log().find("found 'nan'"), std::string::npos) << endless.log();
  Process nowhere = daemons_.run("cleave", {"record", (folder_.path() / "b" / "a.mcap").string()});
  EXPECT_EQ(nowhere.wait(), 1) << nowhere.log();
  EXPECT_NE(nowhere.log().find("is no folder"), std::string::npos) << nowhere.log();
}

TEST_F(Fault, LosslessModeSurvivesASegmenterThatIsKilledHalfWay) {
  for (int i = 0; i < 60; ++i) {
    write_pcd(folder_.path() / ("b" + std::to_string(i) + ".pcd"), 80, 60);
  }
  Process camera = daemons_.grabber("pcd:" + folder_.path().string(), {"--lossless"});
  {
    Process segmenter = daemons_.segmenter({"--lossless"});
    ASSERT_TRUE(segments_flow(10)) << camera.log();
    segmenter.signal(SIGKILL);
    (void)segmenter.wait();
  }
  Process segmenter = daemons_.segmenter({"--lossless"});
  EXPECT_EQ(camera.wait(), 0) << camera.log();
  monitor_.poll();
  std::vector<bool> seen(62);
  for (const ListSummary& list : monitor_.lists()) seen.at(list.frame_id) = true;
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 61) << "every frame has a segment list";
}

}  // namespace
}  // namespace cleave::test
