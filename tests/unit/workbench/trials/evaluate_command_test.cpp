// SPDX-License-Identifier: BSD-3-Clause
// `cleave evaluate` as a user calls it, on a folder of small labelled scenes.
#include "workbench/commands/evaluate_command.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "console/json.hpp"
#include "tests/unit/workbench/trials/labelled_folder.hpp"

namespace cleave::workbench {
namespace {

struct Output {
  int code;
  std::string text;
};

Output run_evaluate(std::vector<std::string> words) {
  CLI::App app;
  Action action;
  add_evaluate_command(app, action);
  words.insert(words.begin(), "evaluate");
  std::reverse(words.begin(), words.end());
  app.parse(words);
  testing::internal::CaptureStdout();
  int code = -1;
  try {
    code = action();
  } catch (...) {
    (void)testing::internal::GetCapturedStdout();
    throw;
  }
  return {code, testing::internal::GetCapturedStdout()};
}

TEST(EvaluateCommand, ComparesAlgorithmsInOneRun) {
  const LabelledFolder folder;

  const Output output = run_evaluate(
      {folder.path(), "--algorithm", "ssc,thesis", "--algorithm", "convex-components", "--json"});

  EXPECT_EQ(output.code, exit_done);
  const Json json = Json::parse(output.text);
  EXPECT_EQ(json["scenes"], 3);
  EXPECT_GT(json["weighted_covering"]["min"], 0.9);
  EXPECT_GT(json["milliseconds"]["median"], 0);
  ASSERT_EQ(json["algorithms"].size(), 3U);
  EXPECT_TRUE(json["algorithms"].contains("convex-components"));
}

TEST(EvaluateCommand, WritesATableForSpreadsheetsAndAPictureAScene) {
  const LabelledFolder folder;
  const auto csv = folder.path() / "runs.csv";
  const auto pictures = folder.path() / "sheets" / "of today";

  const Output output = run_evaluate({folder.path(), "--grid-offsets", "2", "--csv", csv,
                                      "--pictures", pictures, "--groups", "0-1,2"});

  EXPECT_EQ(output.code, exit_done);
  EXPECT_NE(output.text.find("Scenes 0-1, 2 of them:"), std::string::npos) << output.text;
  const std::string lines = tests::read_file(csv);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 1 + 3 * 2);
  for (const char* name : {"000-scene1.png", "001-scene2.png", "002-scene10.png"}) {
    EXPECT_EQ(tests::read_file(pictures / name).substr(1, 3), "PNG") << name;
  }
}

TEST(EvaluateCommand, FailsWhereASceneHadToBeSkippedButTellsOfTheOthers) {
  const LabelledFolder folder;
  folder.add_damaged("scene3.pcd");

  const Output output = run_evaluate({folder.path(), "--json"});

  EXPECT_EQ(output.code, exit_failed);
  const Json json = Json::parse(output.text.substr(output.text.find('{')));  // the log is before it
  EXPECT_EQ(json["skipped"], 1);
  EXPECT_EQ(json["scenes"], 3);
}

TEST(EvaluateCommand, FailsWhereThereIsNothingToJudge) {
  const tests::TemporaryFolder empty;
  EXPECT_THROW((void)run_evaluate({empty.path()}), std::runtime_error);

  const LabelledFolder folder;
  folder.add_unlabelled("a.pcd");
  EXPECT_THROW((void)run_evaluate({folder.path() / "a.pcd"}), std::runtime_error);
}

TEST(EvaluateCommand, RefusesWrongUsageBeforeItWorks) {
  const LabelledFolder folder;

  EXPECT_THROW((void)run_evaluate({folder.path(), "--algorithm", "magic"}), UsageError);
  EXPECT_THROW((void)run_evaluate({folder.path(), "--algorithm", "ssc,ssc"}), UsageError);
  EXPECT_THROW((void)run_evaluate({folder.path(), "--groups", "0-9"}), UsageError);
  EXPECT_THROW((void)run_evaluate({folder.path(), "--set", "voxel.size_m=big"}), UsageError);
}

TEST(EvaluateCommand, LeavesNothingBehindWhereTheTableCannotBeWritten) {
  const LabelledFolder folder;

  EXPECT_THROW((void)run_evaluate({folder.path(), "--csv", "/nowhere/at/all/runs.csv"}),
               std::runtime_error);
  EXPECT_THROW((void)run_evaluate({folder.path(), "--csv", "/dev/full"}), std::runtime_error);
}

}  // namespace
}  // namespace cleave::workbench
