// SPDX-License-Identifier: BSD-3-Clause
// The whole command line of `cleave-workbench`.
#pragma once

#include "console/command.hpp"

namespace cleave::workbench {

// Describes the program and adds every subcommand; parsing sets `action`, which must live as long.
// It speaks as `cleave`, which is what people call: client/cleave/commands/workbench_commands.hpp.
void describe_command_line(CLI::App& app, Action& action);

}  // namespace cleave::workbench
