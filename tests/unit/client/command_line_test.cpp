// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/command_line.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "cleave/commands/workbench_commands.hpp"
#include "cleave/stream/live_options.hpp"
#include "tests/support/run_command.hpp"

namespace cleave::client {
namespace {

int parse(std::vector<std::string> words) {
  return tests::parse_command_line(describe_command_line, std::move(words));
}

TEST(CommandLine, GivesAnExampleForEveryCommandOfItsOwn) {
  CLI::App app;
  Action action;
  describe_command_line(app, action);
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  EXPECT_EQ(commands.size(), 10U + workbench_commands.size());
  for (CLI::App* command : commands) {
    EXPECT_FALSE(command->get_description().empty());
    if (is_workbench_command(command->get_name())) continue;
    const std::string help = command->help();
    EXPECT_NE(help.find("Examples:\n  cleave " + command->get_name()), std::string::npos) << help;
  }
  EXPECT_NE(app.help().find("Examples:"), std::string::npos);
}

TEST(CommandLine, TellsTheWorkbenchsCommandsFromItsOwn) {
  for (const auto& command : workbench_commands) EXPECT_TRUE(is_workbench_command(command.name));
  for (const char* const word : {"status", "--help", "", "segments"}) {
    EXPECT_FALSE(is_workbench_command(word)) << word;
  }
}

TEST(CommandLine, UnderstandsEachCommand) {
  EXPECT_EQ(parse({"list", "--json"}), 0);
  EXPECT_EQ(parse({"record", "--topics", "cloud,labels", "--duration", "5", "out.mcap"}), 0);
  EXPECT_EQ(parse({"replay", "in.mcap", "--rate", "2", "--start", "1", "--end", "3"}), 0);
  EXPECT_EQ(parse({"replay", "in.mcap", "--as-fast-as-possible", "--loop", "--lossless"}), 0);
  EXPECT_EQ(parse({"replay", "in.mcap", "--max-gap", "0.5"}), 0);
  EXPECT_EQ(parse({"info", "in.mcap", "--json"}), 0);
  EXPECT_EQ(parse({"recover", "in.mcap", "out.mcap"}), 0);
  EXPECT_EQ(parse({"convert", "in.mcap", "out"}), 0);
  EXPECT_EQ(parse({"echo", "--sensor", "camera", "--frames", "3"}), 0);
  EXPECT_EQ(parse({"hz", "--duration", "2.5"}), 0);
  EXPECT_EQ(parse({"status", "--watch", "--domain", "7"}), 0);
  EXPECT_EQ(parse({"watch", "--frames", "3", "--picture", "p.png", "--no-shared-memory"}), 0);
}

TEST(CommandLine, RefusesWrongUsage) {
  EXPECT_NE(parse({}), 0);
  EXPECT_NE(parse({"dance"}), 0);
  EXPECT_NE(parse({"watch", "--domain", "100"}), 0);
  EXPECT_NE(parse({"watch", "--sensor", "a/b"}), 0);
  EXPECT_NE(parse({"watch", "--frames", "0"}), 0);
  EXPECT_NE(parse({"hz", "--frames", "1", "--duration", "1"}), 0);
}

TEST(StreamOptions, TakeTheDomainFromTheCommandLineBeforeTheEnvironment) {
  setenv("CLEAVE_DOMAIN", "12", 1);
  EXPECT_EQ(stream_options({}).domain, 12U);
  EXPECT_EQ(stream_options({.domain = 3}).domain, 3U);
  setenv("CLEAVE_DOMAIN", "twelve", 1);
  EXPECT_THROW((void)stream_options({}), UsageError);
  unsetenv("CLEAVE_DOMAIN");
  EXPECT_EQ(stream_options({}).domain, 0U);
}

}  // namespace
}  // namespace cleave::client
