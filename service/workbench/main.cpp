// SPDX-License-Identifier: BSD-3-Clause
// The program `cleave-workbench`: those commands of `cleave` that segment and judge.
#include "console/program.hpp"
#include "workbench/commands/command_line.hpp"

int main(int argc, char** argv) {
  return cleave::run_command_line(argc, argv, CLEAVE_VERSION,
                                  cleave::workbench::describe_command_line);
}
