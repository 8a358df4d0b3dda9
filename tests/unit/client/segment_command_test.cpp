// `cleave segment` as a user calls it, on clouds of a few hundred points.
#include "cleave/commands/segment_command.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "cleave/console/json.hpp"
#include "recording/pcd/cloud.hpp"
#include "temporary_folder.hpp"

namespace cleave::client {
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
  CLI::App app;
  Action action;
  add_segment_command(app, action);
  words.insert(words.begin(), "segment");
  std::reverse(words.begin(), words.end());
  app.parse(words);
  return action();
}

TEST(SegmentCommand, WritesTheLabelledCloudAndItsPicture) {
  const TemporaryFolder folder;
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
  EXPECT_EQ(read_file(picture).substr(1, 3), "PNG");
}

TEST(SegmentCommand, RefusesACloudWithoutAFinitePointAndWritesNothing) {
  const TemporaryFolder folder;
  const auto input =
      folder.file("in.pcd",
                  "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                  "DATA ascii\nnan nan nan\n");
  EXPECT_THROW((void)run_segment({input, folder.path() / "out.pcd"}), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.pcd"));
}

TEST(SegmentCommand, RefusesAnOptionThatDoesNotExistAsWrongUsage) {
  const TemporaryFolder folder;
  const auto input = folder.file("in.pcd", plane());
  EXPECT_THROW((void)run_segment({input, folder.path() / "out.pcd", "--set", "speed=9"}),
               UsageError);
}

}  // namespace
}  // namespace cleave::client
