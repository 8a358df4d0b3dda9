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
#include <vector>

#include "libcleave/process/companion.hpp"

namespace cleave::client {
namespace {

[[noreturn]] void run_workbench(std::string command, std::vector<std::string> words) {
  const std::filesystem::path program =
      companion("cleave-workbench", "'cleave " + command +
                                        "' is run by that program: install the package "
                                        "cleave-workbench, or build the target of that name");
  words.insert(words.begin(), {program.string(), std::move(command)});
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  throw std::runtime_error("cannot start " + program.string() + ": " + std::strerror(errno));
}

}  // namespace

void add_workbench_commands(CLI::App& app, Action& action) {
  for (const auto& [name, description] : workbench_commands) {
    CLI::App* command = app.add_subcommand(std::string(name), std::string(description));
    command->set_help_flag();  // --help is the other program's as well
    command->prefix_command();
    command->callback([command, &action] {
      action = [command]() -> int { run_workbench(command->get_name(), command->remaining()); };
    });
  }
}

}  // namespace cleave::client
