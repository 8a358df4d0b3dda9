// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/command_line.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cleave/commands/workbench_commands.hpp"

namespace cleave::workbench {
namespace {

// Exit code of CLI11 for a command line; 0 = understood.
int parse(std::vector<std::string> words) {
  CLI::App app;
  Action action;
  describe_command_line(app, action);
  std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code();
  }
  EXPECT_TRUE(action) << "no action was chosen";
  return 0;
}

TEST(WorkbenchCommandLine, HasTheCommandsThatCleaveHandsOver) {
  CLI::App app;
  Action action;
  describe_command_line(app, action);
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  ASSERT_EQ(commands.size(), client::workbench_commands.size());
  for (std::size_t i = 0; i < commands.size(); ++i) {
    EXPECT_EQ(commands[i]->get_name(), client::workbench_commands[i].name);
    EXPECT_EQ(commands[i]->get_description(), client::workbench_commands[i].description);
  }
}

TEST(WorkbenchCommandLine, GivesAnExampleForEveryCommand) {
  CLI::App app;
  Action action;
  describe_command_line(app, action);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string help = command->help();
    EXPECT_NE(help.find("Examples:\n  cleave " + command->get_name()), std::string::npos) << help;
  }
}

TEST(WorkbenchCommandLine, UnderstandsEachCommand) {
  EXPECT_EQ(parse({"verify", "in.mcap", "--expect", "golden.mcap", "--workers", "4"}), 0);
  EXPECT_EQ(parse({"segment", "--set", "a=1", "in.pcd", "out.pcd", "--set", "b=2"}), 0);
  EXPECT_EQ(parse({"bench", "folder", "--repeat", "5"}), 0);
  EXPECT_EQ(parse({"bench", "folder", "in.pcd", "--against", "pcl", "--set", "a=1", "--json"}), 0);
  EXPECT_EQ(parse({"bench", "folder", "--grid-offsets", "12", "--collapse"}), 0);
  EXPECT_EQ(parse({"bench", "folder", "--growth"}), 0);
}

TEST(WorkbenchCommandLine, RefusesWrongUsage) {
  EXPECT_NE(parse({}), 0);
  EXPECT_NE(parse({"dance"}), 0);
  EXPECT_NE(parse({"segment", "in.pcd"}), 0);
  EXPECT_NE(parse({"bench", "folder", "--repeat", "0"}), 0);
  EXPECT_NE(parse({"bench", "folder", "--against", "ros"}), 0);
}

}  // namespace
}  // namespace cleave::workbench
