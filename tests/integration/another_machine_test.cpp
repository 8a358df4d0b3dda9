// SPDX-License-Identifier: BSD-3-Clause
// Two machines, which are two network namespaces with a cable between them: what works from the
// other one, and what a bad cable does.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include "recording/frames/frame_reader.hpp"
#include "tests/integration/support/process.hpp"
#include "tests/integration/support/two_machines.hpp"

namespace cleave::test {
namespace {

class AnotherMachine : public testing::Test {
 protected:
  void SetUp() override {
    if (!machines_.ready()) GTEST_SKIP() << no_rights;
  }
  static std::string config(const std::string& name) {
    return std::string(CLEAVE_SOURCE_DIR) + "/config/" + name;
  }
  // Lossless, for the tests whose subject is the network: a busy machine drops frames itself.
  [[nodiscard]] Process segmenter() const {
    return machines_.robot({"cleave-segmenter", "--config", config("segmenter.yaml"),
                            "--no-shared-memory", "--lossless"});
  }
  [[nodiscard]] Process grabber() const {
    return machines_.robot({"cleave-grabber", "--config", config("grabber.yaml"),
                            "--no-shared-memory", "--lossless", "--source", "synthetic:simple",
                            "--fps", "20"});
  }
  // Lists that the office sees in its next 60.
  [[nodiscard]] std::string gaps_in_60_lists() const {
    Process hz = machines_.office({"cleave", "hz", "--frames", "60", "--json"});
    EXPECT_EQ(hz.wait(), 0) << hz.log();
    return hz.output();
  }

  const TwoMachines machines_{36};
  const TemporaryFolder folder_;
};

TEST_F(AnotherMachine, SeesStatusListsRatesAndRecordsThem) {
  Process segments = segmenter();
  Process clouds = grabber();
  ASSERT_TRUE(segments.logs("ready")) << segments.log();

  Process status = machines_.office({"cleave", "status", "--json"});
  EXPECT_EQ(status.wait(), 0) << status.log();
  EXPECT_NE(status.output().find("segmenter/camera"), std::string::npos) << status.output();
  Process echo = machines_.office({"cleave", "echo", "--frames", "2", "--json"});
  EXPECT_EQ(echo.wait(), 0) << echo.log();
  EXPECT_NE(echo.output().find("\"segments\""), std::string::npos) << echo.output();
  EXPECT_NE(gaps_in_60_lists().find("\"gaps\":0"), std::string::npos);
  Process watch = machines_.office({"cleave", "watch", "--frames", "20", "--json"});
  EXPECT_EQ(watch.wait(), 0) << watch.log();

  const std::string file = (folder_.path() / "lists.mcap").string();
  Process record =
      machines_.office({"cleave", "record", "--topics", "segments", "--duration", "1", file});
  EXPECT_EQ(record.wait(), 0) << record.log();
  recording::FrameReader reader(file);
  int lists = 0;
  while (const auto frame = reader.next()) lists += frame->kind() == recording::Kind::segments;
  EXPECT_GE(lists, 10);
}

TEST_F(AnotherMachine, IsToldToNameItsInterfaceWhereItDidNot) {
  Process segments = segmenter();
  Process clouds = grabber();
  ASSERT_TRUE(segments.logs("ready")) << segments.log();
  Process status = machines_.office({"cleave", "status", "--interface", "lo"});
  EXPECT_EQ(status.wait(), 1);
  EXPECT_NE(status.log().find("--interface"), std::string::npos) << status.log();
  Process wrong = machines_.office({"cleave", "status", "--interface", "nosuch0"});
  EXPECT_EQ(wrong.wait(), 1);
  EXPECT_NE(wrong.log().find("nosuch0"), std::string::npos) << wrong.log();
}

class BadCable : public AnotherMachine, public testing::WithParamInterface<const char*> {};

TEST_P(BadCable, ThatLosesPacketsLosesNoList) {
  Process segments = segmenter();
  Process clouds = grabber();
  ASSERT_TRUE(segments.logs("ready")) << segments.log();
  machines_.lose(GetParam());
  const std::string seen = gaps_in_60_lists();
  EXPECT_NE(seen.find("\"gaps\":0"), std::string::npos) << seen;
}

INSTANTIATE_TEST_SUITE_P(Loss, BadCable, testing::Values("0.01", "0.05"),
                         [](const auto& loss) { return std::string(loss.param).substr(2); });

TEST_F(AnotherMachine, GoesOnByItselfAfterTheCableWasUnpluggedForFiveSeconds) {
  Process segments = segmenter();
  Process clouds = grabber();
  ASSERT_TRUE(segments.logs("ready")) << segments.log();
  Process echo = machines_.office({"cleave", "echo", "--json"});
  ASSERT_TRUE(eventually([&] { return !echo.output().empty(); })) << echo.log();
  machines_.unplug();
  ::sleep(5);
  machines_.plug_in();
  const std::size_t before = echo.output().size();
  EXPECT_TRUE(eventually([&] { return echo.output().size() > before + 1000; })) << echo.log();
  // The robot did not wait for the office.
  Process status = machines_.robot({"cleave", "status", "--json"});
  EXPECT_EQ(status.wait(), 0) << status.log();
  EXPECT_NE(status.output().find("\"frames_dropped\":0"), std::string::npos) << status.output();
  echo.signal(SIGTERM);
  EXPECT_EQ(echo.wait(), 0) << echo.log();
}

}  // namespace
}  // namespace cleave::test
