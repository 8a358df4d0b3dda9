// SPDX-License-Identifier: BSD-3-Clause
// The program `cleave`.
#include "cleave/commands/command_line.hpp"
#include "cleave/commands/workbench_commands.hpp"
#include "console/program.hpp"

int main(int argc, char** argv) {
  using namespace cleave;
  if (argc > 1 && client::is_workbench_command(argv[1])) {
    return run_program([argv]() -> int { client::run_workbench(argv); });
  }
  return run_command_line(argc, argv, CLEAVE_VERSION, client::describe_command_line);
}
