// SPDX-License-Identifier: BSD-3-Clause
// A subcommand as a user calls it.
#pragma once

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

}  // namespace cleave::tests
