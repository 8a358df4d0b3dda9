// SPDX-License-Identifier: BSD-3-Clause
// `cleave study` as a user calls it.
#include "workbench/commands/study_command.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "tests/unit/workbench/trials/labelled_folder.hpp"
#include "workbench/studies/rendered_scenes.hpp"

namespace cleave::workbench {
namespace {

int run_study(std::vector<std::string> words) {
  CLI::App app;
  Action action;
  add_study_command(app, action);
  words.insert(words.begin(), "study");
  std::reverse(words.begin(), words.end());
  app.parse(words);
  return action();
}

// Programs are looked for in an empty folder while it lives.
class NoPrograms {
 public:
  NoPrograms() { setenv("PATH", empty_.path().c_str(), 1); }
  ~NoPrograms() { setenv("PATH", before_.c_str(), 1); }
  NoPrograms(const NoPrograms&) = delete;
  NoPrograms& operator=(const NoPrograms&) = delete;

 private:
  tests::TemporaryFolder empty_;
  std::string before_ = std::getenv("PATH");
};

TEST(StudyCommand, WritesDataAndPlotsOfAnyLabelledFolder) {
  const LabelledFolder scenes;
  const tests::TemporaryFolder folder;
  const auto output = folder.path() / "figures";

  EXPECT_EQ(run_study({"cannot-link-threshold", scenes.path(), "--output", output, "--jobs", "2"}),
            exit_done);

  for (const char* ending : {".dat", ".gnuplot", ".svg", ".png"}) {
    EXPECT_FALSE(tests::read_file(output / (std::string("cannot-link-threshold") + ending)).empty())
        << ending;
  }
}

TEST(StudyCommand, CountsTheEigenvectorsThatTrueCutsNeed) {
  const LabelledFolder scenes;
  const tests::TemporaryFolder folder;

  EXPECT_EQ(run_study({"eigenvectors-used", scenes.path(), "--output", folder.path()}), exit_done);

  EXPECT_NE(tests::read_file(folder.path() / "eigenvectors-used.dat").find("\n1 "),
            std::string::npos);
  EXPECT_EQ(tests::read_file(folder.path() / "eigenvectors-used.png").substr(1, 3), "PNG");
}

TEST(StudyCommand, KeepsTheDataWhereGnuplotIsMissingAndSaysWhatToInstall) {
  const LabelledFolder scenes;
  const tests::TemporaryFolder folder;
  const NoPrograms no_programs;

  try {
    (void)run_study({"cannot-link-weight", scenes.path(), "--output", folder.path()});
    FAIL() << "there is no gnuplot";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("apt-get install gnuplot-nox"), std::string::npos);
  }
  EXPECT_FALSE(tests::read_file(folder.path() / "cannot-link-weight.dat").empty());
}

TEST(StudyCommand, RefusesWrongUsage) {
  EXPECT_THROW((void)run_study({"weather"}), CLI::ParseError);
  EXPECT_THROW((void)run_study({"cannot-link-weight", "--set", "no.such=1"}), UsageError);
}

TEST(RenderedScenes, AreMadeOnceAndKept) {
  const tests::TemporaryFolder folder;

  const auto files = rendered_scenes(folder.path() / "scenes", "medium", 2);
  ASSERT_EQ(files.size(), 2U);
  const auto written = std::filesystem::last_write_time(files[0]);

  EXPECT_EQ(rendered_scenes(folder.path() / "scenes", "medium", 2), files);
  EXPECT_EQ(std::filesystem::last_write_time(files[0]), written);
  EXPECT_TRUE(std::filesystem::exists(files[1]));
}

}  // namespace
}  // namespace cleave::workbench
