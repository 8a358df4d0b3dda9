// SPDX-License-Identifier: BSD-3-Clause
// RouDi absent, gone and back: said aloud, and segments flow.
#include <gtest/gtest.h>

#include <csignal>
#include <optional>
#include <utility>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/roudi_fixture.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

class RouDiFault : public testing::Test {
 protected:
  RouDiFault() { write_pcd(folder_.path() / "a.pcd", 80, 60); }

  Process grabber() { return daemons_.grabber("pcd:" + folder_.path().string(), {"--loop"}); }

  NodeReport segmenter_status() {
    monitor_.poll();
    return monitor_.status("segmenter/camera");
  }

  testing::AssertionResult segments_flow() {
    return monitor_.lists_flow(5) ? testing::AssertionSuccess()
                                  : testing::AssertionFailure() << "no segments come";
  }

  bool zero_copy_flows() {
    return eventually([&] { return segmenter_status().frames_zero_copy > 0; });
  }

  TemporaryFolder folder_;
  Daemons daemons_{13, true};
  Monitor monitor_{13, "camera"};
};

TEST_F(RouDiFault, WithoutRouDiTheNetworkCarriesTheCloudsAndTheLogAndTheStatusSaySo) {
  const RouDiLock nobody_starts_one;
  Process segmenter = daemons_.segmenter();
  const Process camera = grabber();
  ASSERT_TRUE(segments_flow()) << segmenter.log();
  EXPECT_NE(segmenter.log().find("no RouDi answers"), std::string::npos);
  ASSERT_TRUE(eventually([&] { return segmenter_status().frames_in > 0; }));
  EXPECT_EQ(segmenter_status().transport_in_force, Transport::network);
  EXPECT_EQ(segmenter_status().frames_zero_copy, 0U);
}

TEST_F(RouDiFault, WithRouDiEveryCloudIsHandedOverWithoutACopy) {
  const RouDi roudi;
  Process segmenter = daemons_.segmenter();
  Process camera = grabber();
  ASSERT_TRUE(segments_flow()) << segmenter.log() << camera.log();
  ASSERT_TRUE(eventually([&] { return segmenter_status().frames_in > 0; }));
  const NodeReport status = segmenter_status();
  EXPECT_EQ(status.transport_in_force, Transport::shared_memory);
  EXPECT_EQ(status.frames_zero_copy, status.frames_in - status.dropped_by_cause.count("transport"));
}

TEST_F(RouDiFault, ARouDiThatDiesIsReportedWhileSegmentsFlowAndARouDiThatComesBackIsJoined) {
  RouDi roudi;
  Process segmenter = daemons_.segmenter();
  Process camera = grabber();
  ASSERT_TRUE(segments_flow()) << segmenter.log() << camera.log();

  roudi.kill();
  EXPECT_TRUE(eventually([&] {
    return segmenter_status().last_error.find("RouDi") != std::string::npos;
  })) << segmenter.log();
  EXPECT_TRUE(segments_flow()) << segmenter.log();

  roudi.start();
  EXPECT_TRUE(segmenter.logs("restart")) << segmenter.log();
  EXPECT_TRUE(camera.logs("restart")) << camera.log();
  EXPECT_TRUE(eventually([&] { return segmenter_status().last_error.empty(); }));
  EXPECT_TRUE(segments_flow()) << segmenter.log() << camera.log();
  EXPECT_TRUE(segmenter.running());
  EXPECT_TRUE(camera.running());

  camera.signal(SIGTERM);
  EXPECT_EQ(camera.wait(), 0);
  segmenter.signal(SIGTERM);
  EXPECT_EQ(segmenter.wait(), 0);
}

TEST_F(RouDiFault, ARouDiThatIsStartedLateIsJoinedByBothNodesByThemselves) {
  std::optional<RouDiLock> nobody_starts_one(std::in_place);
  Process segmenter = daemons_.segmenter();
  const Process camera = grabber();
  ASSERT_TRUE(segments_flow()) << segmenter.log();
  ASSERT_TRUE(
      eventually([&] { return segmenter_status().transport_in_force == Transport::network; }));
  nobody_starts_one.reset();

  const RouDi roudi;
  EXPECT_TRUE(zero_copy_flows()) << segmenter.log() << camera.log();
  EXPECT_TRUE(segments_flow());
}

TEST_F(RouDiFault, ARouDiThatIsStoppedEndsAndBothNodesGoOnOverTheNetworkUntilTheNextOne) {
  RouDi roudi;
  Process segmenter = daemons_.segmenter();
  Process camera = grabber();
  ASSERT_TRUE(segments_flow()) << segmenter.log() << camera.log();

  EXPECT_EQ(roudi.stop(), 0);
  EXPECT_TRUE(eventually([&] {
    return segmenter_status().transport_in_force == Transport::network;
  })) << segmenter.log();
  EXPECT_TRUE(segments_flow()) << segmenter.log() << camera.log();
  EXPECT_NE(segmenter.log().find("frames received"), std::string::npos) << segmenter.log();

  roudi.start();
  EXPECT_TRUE(zero_copy_flows()) << segmenter.log() << camera.log();
  EXPECT_TRUE(segmenter.running());
  EXPECT_TRUE(camera.running());
}

TEST_F(RouDiFault, ARouDiThatHangsIsNamedByWhoStartsThenAndJoinedWhenItGoesOn) {
  const RouDi roudi;
  ::kill(roudi.id(), SIGSTOP);
  Process segmenter = daemons_.segmenter();
  EXPECT_TRUE(segmenter.logs("is suspended or hangs")) << segmenter.log();
  Process camera = grabber();
  EXPECT_TRUE(segments_flow()) << segmenter.log() << camera.log();
  ::kill(roudi.id(), SIGCONT);
  EXPECT_TRUE(zero_copy_flows()) << segmenter.log() << camera.log();
}

// Nobody can join while RouDi's socket has another name; who has joined keeps its connection.
class RenamedSocket {
 public:
  RenamedSocket() { std::filesystem::rename(socket, other_name); }
  ~RenamedSocket() {
    std::error_code error;
    std::filesystem::rename(other_name, socket, error);
    EXPECT_FALSE(error) << error.message();
  }
  RenamedSocket(const RenamedSocket&) = delete;
  RenamedSocket& operator=(const RenamedSocket&) = delete;

 private:
  static constexpr const char* socket = "/tmp/roudi";
  static constexpr const char* other_name = "/tmp/roudi-renamed";
};

TEST_F(RouDiFault, ARouDiThatCannotBeReachedForAWhileIsAnErrorOfBothNodesThatGoesWhenItIsBack) {
  const RouDi roudi;
  Process segmenter = daemons_.segmenter();
  Process camera = grabber();
  ASSERT_TRUE(segments_flow()) << segmenter.log() << camera.log();
  const auto eventually_both = [this](const auto& condition) {
    return eventually([&] {
      monitor_.poll();
      return condition(monitor_.status("segmenter/camera").last_error) &&
             condition(monitor_.status("grabber/camera").last_error);
    });
  };
  {
    const RenamedSocket renamed;
    EXPECT_TRUE(eventually_both([](const std::string& error) {
      return error.find("RouDi is gone") != std::string::npos;
    })) << segmenter.log()
        << camera.log();
  }
  EXPECT_TRUE(eventually_both([](const std::string& error) { return error.empty(); }))
      << segmenter.log() << camera.log();
  EXPECT_TRUE(segments_flow()) << segmenter.log() << camera.log();
  EXPECT_EQ(segmenter.log().find("restart"), std::string::npos) << segmenter.log();
  EXPECT_EQ(camera.log().find("restart"), std::string::npos) << camera.log();
}

}  // namespace
}  // namespace cleave::test
