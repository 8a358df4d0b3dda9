// SPDX-License-Identifier: BSD-3-Clause
// Bad input in `pcd:DIR` and `oni:FILE`, bad configurations and names: clear errors, exit codes,
// nothing lost.
#include <gtest/gtest.h>

#include <fstream>
#include <utility>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

class BadFiles : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
  }
  // A PCD whose data ends half way.
  void write_truncated(const std::string& name) const {
    write_pcd(folder_.path() / name, 80, 60);
    std::filesystem::resize_file(folder_.path() / name,
                                 std::filesystem::file_size(folder_.path() / name) / 2);
  }
  [[nodiscard]] std::string source() const { return "pcd:" + folder_.path().string(); }

  TemporaryFolder folder_;
  Daemons daemons_{10, false};
};

TEST_F(BadFiles, InAMixedFolderAreSkippedNamedAndCountedAndTheGoodOnesArePublished) {
  write_pcd(folder_.path() / "good1.pcd", 80, 60);
  write_pcd(folder_.path() / "good2.pcd", 80, 60);
  write("empty.pcd", "");
  write("text.pcd", "this is no point cloud\n");
  write("notes.txt", "not a cloud, by its name");
  write_truncated("truncated.pcd");
  write("header_lies.pcd",
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
        "WIDTH 4000000000\nHEIGHT 4000000000\nVIEWPOINT 0 0 0 1 0 0 0\n"
        "POINTS 4000000000\nDATA binary\nxxxx");
  std::filesystem::create_directory(folder_.path() / "folder.pcd");
  std::filesystem::create_symlink("/nonexistent", folder_.path() / "missing.pcd");

  Monitor monitor(10, "camera");
  Process segmenter = daemons_.segmenter({"--lossless"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process grabber = daemons_.grabber(source(), {"--lossless"});
  ASSERT_TRUE(eventually([&] {
    monitor.poll();
    return monitor.lists().size() == 2;
  })) << grabber.log();
  EXPECT_EQ(grabber.wait(), 0);
  for (const char* name :
       {"empty.pcd", "text.pcd", "truncated.pcd", "header_lies.pcd", "folder.pcd", "missing.pcd"}) {
    EXPECT_NE(grabber.log().find(name), std::string::npos) << name << " is not named";
  }
  ASSERT_TRUE(eventually([&] {
    monitor.poll();
    return monitor.status("grabber/camera").frames_out == 2;
  }));
  EXPECT_GE(monitor.status("grabber/camera").frames_rejected, 6U);
}

TEST_F(BadFiles, AloneEndTheGrabberWith1AndAMessageThatSaysWhatWasLookedFor) {
  write("text.pcd", "this is no point cloud\n");
  Process grabber = daemons_.grabber(source());
  EXPECT_EQ(grabber.wait(), 1);
  EXPECT_NE(grabber.log().find(folder_.path().string()), std::string::npos);
}

TEST_F(BadFiles, AnEmptyFolderEndsTheGrabberWith1) {
  Process grabber = daemons_.grabber(source());
  EXPECT_EQ(grabber.wait(), 1);
  EXPECT_NE(grabber.log().find(folder_.path().string()), std::string::npos);
}

TEST_F(BadFiles, AMissingFolderEndsTheGrabberWith1) {
  Process grabber = daemons_.grabber("pcd:/nonexistent/folder");
  EXPECT_EQ(grabber.wait(), 1);
  EXPECT_NE(grabber.log().find("/nonexistent/folder"), std::string::npos);
}

TEST_F(BadFiles, ACloudOfMoreThan1600x1200PointsIsSkippedAndNamed) {
  write_pcd(folder_.path() / "large.pcd", 1601, 1200);
  Process grabber = daemons_.grabber(source());
  EXPECT_EQ(grabber.wait(), 1);
  EXPECT_NE(grabber.log().find("large.pcd"), std::string::npos);
  EXPECT_NE(grabber.log().find("1920000"), std::string::npos) << grabber.log();
}

TEST_F(BadFiles, ADamagedOniRecordingEndsTheGrabberWith1AndSaysWhy) {
  write("cut.oni", "NI10");
  write("text.oni", "this is no recording\n");
  for (const auto& [name, why] :
       {std::pair("cut.oni", "ends in its header"),
        std::pair("text.oni", "does not begin with NI10"), std::pair("none.oni", "No such file")}) {
    const std::string file = (folder_.path() / name).string();
    Process grabber = daemons_.grabber("oni:" + file);
    EXPECT_EQ(grabber.wait(), 1) << grabber.log();
    EXPECT_NE(grabber.log().find(file), std::string::npos) << grabber.log();
    EXPECT_NE(grabber.log().find(why), std::string::npos) << grabber.log();
  }
}

struct WrongYaml {
  const char* text;
  const char* expected;  // in the message
};

class BadConfiguration : public testing::TestWithParam<WrongYaml> {};

TEST_P(BadConfiguration, EndsBothDaemonsWith2AndNamesFileLineKeyAndWhatWasExpected) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "wrong.yaml").string();
  std::ofstream(file) << "# first line\n" << GetParam().text;
  for (const char* name : {"cleave-grabber", "cleave-segmenter"}) {
    Process daemon({program(name), "--config", file});
    EXPECT_EQ(daemon.wait(), 2) << name << daemon.log();
    EXPECT_NE(daemon.log().find("wrong.yaml:2"), std::string::npos) << daemon.log();
    EXPECT_NE(daemon.log().find(GetParam().expected), std::string::npos) << daemon.log();
  }
}

INSTANTIATE_TEST_SUITE_P(Yaml, BadConfiguration,
                         testing::Values(WrongYaml{"no_such_key: 1\n", "no_such_key"},
                                         WrongYaml{"mode: 17\n", "lossless"},
                                         WrongYaml{"stream: {domain: many}\n", "domain"},
                                         WrongYaml{"stream: {domain: 100}\n", "99"}));

TEST(SensorNameThatIsTooLong, EndsBothDaemonsWith2) {
  for (const char* name : {"cleave-grabber", "cleave-segmenter"}) {
    Process daemon({program(name), "--config",
                    std::string(CLEAVE_SOURCE_DIR) + "/config/" +
                        (std::string(name) == "cleave-grabber" ? "grabber" : "segmenter") + ".yaml",
                    "--sensor", std::string(64, 'a')});
    EXPECT_EQ(daemon.wait(), 2) << name;
    EXPECT_NE(daemon.log().find("63"), std::string::npos) << daemon.log();
  }
}

}  // namespace
}  // namespace cleave::test
