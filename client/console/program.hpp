// SPDX-License-Identifier: BSD-3-Clause
// The main function of a program whose commands are CLI11's subcommands.
#pragma once

#include <string_view>

#include "console/command.hpp"

namespace cleave {

// Adds the subcommands; parsing sets the action, which lives as long as the program.
using DescribeCommandLine = void (*)(CLI::App& app, Action& action);

// Runs it, and says on stderr what went wrong. Returns the exit code.
[[nodiscard]] int run_program(const Action& program);

// Parses, and runs the action in the same way. Data that did not reach stdout, e.g. for want of
// room, is a failure.
[[nodiscard]] int run_command_line(int argc, char** argv, std::string_view version,
                                   DescribeCommandLine describe);

}  // namespace cleave
