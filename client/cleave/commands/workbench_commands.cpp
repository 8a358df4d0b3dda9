// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/workbench_commands.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "libcleave/process/companion.hpp"

namespace cleave::client {

void add_workbench_commands(CLI::App& app) {
  for (const auto& [name, description] : workbench_commands) {
    app.add_subcommand(std::string(name), std::string(description));
  }
}

bool is_workbench_command(std::string_view word) {
  return std::ranges::find(workbench_commands, word, &WorkbenchCommand::name) !=
         workbench_commands.end();
}

void run_workbench(char** words) {
  const std::filesystem::path program =
      companion("cleave-workbench", "'cleave " + std::string(words[1]) +
                                        "' is run by that program: install the package "
                                        "cleave-workbench, or build the target of that name");
  execv(program.c_str(), words);
  throw std::runtime_error("cannot start " + program.string() + ": " + std::strerror(errno));
}

}  // namespace cleave::client
