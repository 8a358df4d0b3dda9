// SPDX-License-Identifier: BSD-3-Clause
// Commands as a user calls them.
#pragma once

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "console/command.hpp"

namespace cleave::tests {

// `words` begin with the subcommand's name. Returns its exit code; throws what it throws.
inline int run_command(void (*add)(CLI::App&, Action&), std::vector<std::string> words) {
  CLI::App app;
  Action action;
  add(app, action);
  std::reverse(words.begin(), words.end());
  app.parse(words);
  return action();
}

// CLI11's exit code of a command line, which is not run; 0 = understood.
inline int parse_command_line(void (*describe)(CLI::App&, Action&),
                              std::vector<std::string> words) {
  CLI::App app;
  Action action;
  describe(app, action);
  std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code();
  }
  EXPECT_TRUE(action) << "no action was chosen";
  return 0;
}

}  // namespace cleave::tests
