// SPDX-License-Identifier: BSD-3-Clause
// The inputs of data/cases, each of which went wrong once: what its NOTE.txt says should happen,
// with the programs that a stranger would use.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/support/data_folder.hpp"

namespace cleave::test {
namespace {

using nlohmann::json;

// A program that runs to its end.
struct Ended {
  int code = 0;
  std::string output;
  std::string log;
};

Ended run(std::vector<std::string> command) {
  command.front() = program(command.front());
  Process process(command);
  const int code = process.wait();
  return {code, process.output(), process.log()};
}

std::vector<std::size_t> point_counts(const json& report) {
  std::vector<std::size_t> counts;
  for (const auto& segment : report["segments"]) counts.push_back(segment["point_count"]);
  return counts;
}

class Case : public testing::Test {
 protected:
  // The path of an input; the test is skipped where the folder is absent.
  void SetUp() override {
    if (!tests::find_data("cases")) GTEST_SKIP() << "data/cases is not here: set CLEAVE_DATA";
  }
  [[nodiscard]] static std::string input(const std::string& name) {
    return (*tests::find_data("cases") / name).string();
  }
  [[nodiscard]] std::string output(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  [[nodiscard]] Ended segment(const std::string& name,
                              const std::vector<std::string>& options = {}) const {
    std::vector<std::string> command = {"cleave", "segment", input(name), output("out.pcd"),
                                        "--json"};
    command.insert(command.end(), options.begin(), options.end());
    return run(command);
  }
  TemporaryFolder folder_;
};

struct Table {
  const char* input;
  std::size_t segments;              // that a person sees; the notes also count single pixels
  std::vector<std::size_t> largest;  // points, where the note names them
  std::vector<std::string> options = {};
};

class TableTop : public Case, public testing::WithParamInterface<Table> {};

TEST_P(TableTop, HasTheSegmentsThatItsNoteNames) {
  const Table& table = GetParam();
  const Ended ended = segment(table.input, table.options);
  ASSERT_EQ(ended.code, 0) << ended.log;
  const std::vector<std::size_t> counts = point_counts(json::parse(ended.output));
  EXPECT_EQ(counts.size(), table.segments);
  ASSERT_GE(counts.size(), table.largest.size());
  for (std::size_t i = 0; i < table.largest.size(); ++i) {
    const auto expected = static_cast<double>(table.largest[i]);
    EXPECT_NEAR(static_cast<double>(counts[i]), expected, .02 * expected) << "segment " << i + 1;
  }
}

const std::vector<std::size_t> clean_image = {7734, 934, 813, 627};

INSTANTIATE_TEST_SUITE_P(
    Cases, TableTop,
    testing::Values(Table{"camera-not-along-z/z_backward.pcd", 4, clean_image},
                    Table{"camera-not-along-z/map_frame.pcd", 4, clean_image},
                    Table{"one-point-at-the-origin/one.pcd", 4, clean_image},
                    Table{"zeros-are-no-measurement/zeros.pcd", 4, clean_image},
                    Table{"millimetres/mm.pcd", 4, clean_image, {"--unit", "mm"}},
                    Table{"dust-segments/clean_table.pcd", 4, {11457}},
                    Table{"downsampled-table/leaf_1cm.pcd", 4, {}}));

TEST_F(Case, MillimetresAreRefusedByAMessageThatNamesTheOption) {
  const Ended ended = segment("millimetres/mm.pcd");
  EXPECT_EQ(ended.code, 1);
  EXPECT_NE(ended.log.find("--unit mm"), std::string::npos) << ended.log;
}

TEST_F(Case, APortraitImageIsSegmentedAsAnyOther) {
  const Ended ended = segment("portrait-image-crashes/column_major.pcd");
  ASSERT_EQ(ended.code, 0) << ended.log;
  const std::vector<std::size_t> counts = point_counts(json::parse(ended.output));
  EXPECT_GE(counts.size(), 2U);
  EXPECT_LE(counts.size(), 40U);
}

TEST_F(Case, AnImageOfMoreThan640x480PointsIsConvertedAndStreamedWholeOrThinned) {
  const std::string images = input("larger-than-vga");
  const Ended whole = run({"cleave", "convert", images, output("whole.mcap")});
  EXPECT_EQ(whole.code, 0) << whole.log;
  const Ended thinned =
      run({"cleave", "convert", images, output("thinned.mcap"), "--decimate", "2"});
  ASSERT_EQ(thinned.code, 0) << thinned.log;
  const Ended info = run({"cleave", "info", output("thinned.mcap"), "--json"});
  EXPECT_EQ(info.code, 0) << info.log;

  Daemons daemons(10, false);
  Monitor monitor(10, "camera");
  Process segmenter = daemons.segmenter({"--lossless"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  std::size_t lists = 0;
  for (const char* const decimate : {"1", "2"}) {
    Process grabber = daemons.grabber("pcd:" + images, {"--lossless", "--decimate", decimate});
    ++lists;
    ASSERT_TRUE(eventually([&] {
      monitor.poll();
      return monitor.lists().size() == lists;
    })) << grabber.log();
    EXPECT_EQ(grabber.wait(), 0) << grabber.log();
  }
}

TEST_F(Case, ARecordingWhoseClockJumpsPlaysOn) {
  Daemons daemons(10, false);
  Monitor monitor(10, "camera");
  Process segmenter = daemons.segmenter();
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process grabber = daemons.grabber("mcap:" + input("mcap-clock-jump/jump.mcap"));
  EXPECT_EQ(grabber.wait(), 0) << grabber.log();
  EXPECT_NE(grabber.log().find("max-gap"), std::string::npos) << grabber.log();
  EXPECT_TRUE(eventually([&] {
    monitor.poll();
    return monitor.status("grabber/camera").frames_out == 3;
  }));
}

TEST_F(Case, HeadersWithAByteOrderMarkAndWithPaddingOfNoBytesAreRead) {
  EXPECT_EQ(segment("pcd-bom/bom.pcd").code, 0) << segment("pcd-bom/bom.pcd").log;
  EXPECT_EQ(segment("pcd-padding-count-0/ouster.pcd").code, 0)
      << segment("pcd-padding-count-0/ouster.pcd").log;
}

struct Recording {
  const char* input;
  std::size_t messages;
};

class WholeMcap : public Case, public testing::WithParamInterface<Recording> {};

TEST_P(WholeMcap, IsCountedWholeAndRecoveredWithoutDamage) {
  const std::string file = input(GetParam().input);
  const Ended info = run({"cleave", "info", file, "--json"});
  ASSERT_EQ(info.code, 0) << info.log;
  const json report = json::parse(info.output);
  EXPECT_EQ(report["message_count"], GetParam().messages) << info.output;
  EXPECT_EQ(report["complete"], true) << info.output;

  const Ended recover = run({"cleave", "recover", file, output("whole.mcap")});
  ASSERT_EQ(recover.code, 0) << recover.log;
  EXPECT_EQ(recover.log.find("damaged:"), std::string::npos) << recover.log;
  const Ended again = run({"cleave", "info", output("whole.mcap"), "--json"});
  EXPECT_EQ(json::parse(again.output)["message_count"], GetParam().messages) << again.output;
}

INSTANTIATE_TEST_SUITE_P(
    Cases, WholeMcap,
    testing::Values(Recording{"mcap-without-chunks/unchunked.mcap", 6},
                    Recording{"mcap-without-chunk-index/no_chunk_index.mcap", 6},
                    Recording{"mcap-message-larger-than-chunk/big_outside.mcap", 6},
                    Recording{"mcap-channel-without-schema/schemaless.mcap", 4},
                    Recording{"mcap-private-records/private.mcap", 6},
                    Recording{"mcap-lz4/lz4.mcap", 6}, Recording{"mcap-clock-jump/jump.mcap", 6}));

}  // namespace
}  // namespace cleave::test
