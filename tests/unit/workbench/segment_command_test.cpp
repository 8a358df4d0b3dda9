// SPDX-License-Identifier: BSD-3-Clause
// `cleave segment` as a user calls it, on clouds of a few hundred points.
#include "workbench/commands/segment_command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "console/json.hpp"
#include "recording/pcd/cloud.hpp"
#include "tests/support/run_command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cleave::workbench {
namespace {

// A plane of 40 x 30 points at 1 m, as text.
std::string plane() {
  std::string text =
      "VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 40\n"
      "HEIGHT 30\nPOINTS 1200\nDATA ascii\n";
  for (int row = 0; row < 30; ++row) {
    for (int column = 0; column < 40; ++column) {
      text += std::to_string(column * 0.005) + " " + std::to_string(row * 0.005) + " 1 " +
              std::to_string(row * 40 + column) + "\n";
    }
  }
  return text;
}

int run_segment(std::vector<std::string> words) {
  words.insert(words.begin(), "segment");
  return tests::run_command(add_segment_command, std::move(words));
}

TEST(SegmentCommand, WritesTheLabelledCloudAndItsPicture) {
  const tests::TemporaryFolder folder;
  const auto input = folder.file("in.pcd", plane());
  const auto output = folder.path() / "out.pcd";
  const auto picture = folder.path() / "out.png";

  testing::internal::CaptureStdout();
  EXPECT_EQ(run_segment({input, output, "--picture", picture, "--json"}), exit_done);
  const Json json = Json::parse(testing::internal::GetCapturedStdout());

  EXPECT_EQ(json["points"], 1200);
  EXPECT_EQ(json["segments"].size(), 1U) << "a plane is one segment";
  const auto cloud = recording::PcdCloud::read(output);
  EXPECT_EQ(cloud.header().width, 40U);
  EXPECT_TRUE(cloud.header().find("intensity").has_value());
  EXPECT_TRUE(cloud.header().find("label").has_value());
  EXPECT_EQ(tests::read_file(picture).substr(1, 3), "PNG");
}

TEST(SegmentCommand, RefusesACloudWithoutAFinitePointAndWritesNothing) {
  const tests::TemporaryFolder folder;
  const auto input =
      folder.file("in.pcd",
                  "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                  "DATA ascii\nnan nan nan\n");
  EXPECT_THROW((void)run_segment({input, folder.path() / "out.pcd"}), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.pcd"));
}

// A camera's view of a slope, `scale` units a metre.
std::string slope_as_text(double scale) {
  std::string text =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 40\nHEIGHT 30\nPOINTS 1200\n"
      "DATA ascii\n";
  for (int i = 0; i < 1200; ++i) {
    const double z = scale * (0.7 + 0.001 * (i / 40));
    text += std::to_string(z * (i % 40 - 20) / 500) + " " +
            std::to_string(z * (i / 40 - 15) / 500) + " " + std::to_string(z) + "\n";
  }
  return text;
}

TEST(SegmentCommand, RefusesMillimetresAndNamesTheOptionThatScalesThem) {
  const tests::TemporaryFolder folder;
  const auto input = folder.file("in.pcd", slope_as_text(1000));
  const auto output = folder.path() / "out.pcd";

  try {
    (void)run_segment({input, output});
    FAIL() << "segmented";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("--unit mm"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST(SegmentCommand, ScalesByTheUnitAndWritesTheFilesOwnCoordinates) {
  const tests::TemporaryFolder folder;
  const auto input = folder.file("in.pcd", slope_as_text(1000));
  const auto output = folder.path() / "out.pcd";

  testing::internal::CaptureStdout();
  EXPECT_EQ(run_segment({input, output, "--unit", "mm", "--json"}), exit_done);
  const Json json = Json::parse(testing::internal::GetCapturedStdout());

  ASSERT_EQ(json["segments"].size(), 1U);
  EXPECT_NEAR(json["segments"][0]["centroid"][2], 0.7145, 1e-3);
  const auto before = recording::PcdCloud::read(input);
  const auto after = recording::PcdCloud::read(output);
  EXPECT_TRUE(std::ranges::equal(before.xyz(), after.xyz()));
}

TEST(SegmentCommand, RefusesMoreSegmentsThanLabelsCanName) {
  const tests::TemporaryFolder folder;
  std::string points;
  for (int i = 0; i < 65536; ++i) {
    points += std::to_string(i % 256) + " " + std::to_string(i / 256) + " -1\n";
  }
  const auto input =
      folder.file("in.pcd",
                  "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 65536\nHEIGHT 1\n"
                  "POINTS 65536\nDATA ascii\n" +
                      points);

  EXPECT_THROW(
      (void)run_segment({input, folder.path() / "out.pcd", "--set", "voxel.follow_spacing=false",
                         "--set", "clean_up.min_segment_points=0"}),
      std::runtime_error);
}

TEST(SegmentCommand, RefusesAViewpointThatIsNoneBeforeItReadsAnything) {
  for (const char* const input : {"/no/such.pcd", "/no/such.mcap"}) {
    EXPECT_THROW((void)run_segment({input, "out", "--viewpoint", "1,2"}), UsageError);
    EXPECT_THROW((void)run_segment({input, "out", "--set", "speed=9"}), UsageError);
  }
}

TEST(SegmentCommand, RefusesAnOptionThatDoesNotExistAsWrongUsage) {
  const tests::TemporaryFolder folder;
  const auto input = folder.file("in.pcd", plane());
  EXPECT_THROW((void)run_segment({input, folder.path() / "out.pcd", "--set", "speed=9"}),
               UsageError);
}

TEST(SegmentCommand, RefusesAnOptionThatWouldBeIgnoredAsWrongUsageUnlessItComesWithThePreset) {
  const tests::TemporaryFolder folder;
  const auto input = folder.file("in.pcd", plane());
  const auto output = folder.path() / "out.pcd";
  EXPECT_THROW(
      (void)run_segment({input, output, "--algorithm", "svc", "--set", "graph.max_step_m=0.01"}),
      UsageError);
  EXPECT_THROW((void)run_segment({input, output, "--set", "voxel.neighbourhood=18"}), UsageError);
  EXPECT_FALSE(std::filesystem::exists(output));

  testing::internal::CaptureStdout();
  EXPECT_EQ(run_segment({input, output, "--thesis", "--algorithm", "svc", "--set",
                         "voxel.neighbourhood=26"}),
            exit_done);
  (void)testing::internal::GetCapturedStdout();
}

}  // namespace
}  // namespace cleave::workbench
