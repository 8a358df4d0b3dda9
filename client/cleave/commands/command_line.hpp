// SPDX-License-Identifier: BSD-3-Clause
// The whole command line of `cleave`.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

// Describes the program and adds every subcommand; parsing sets `action`, which must live as long.
void describe_command_line(CLI::App& app, Action& action);

}  // namespace cleave::client
