// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/command_line.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cleave/commands/workbench_commands.hpp"
#include "tests/support/run_command.hpp"

namespace cleave::workbench {
namespace {

int parse(std::vector<std::string> words) {
  return tests::parse_command_line(describe_command_line, std::move(words));
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
