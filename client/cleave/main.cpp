// SPDX-License-Identifier: BSD-3-Clause
// The program `cleave`.
#include "cleave/commands/command_line.hpp"
#include "console/program.hpp"

int main(int argc, char** argv) {
  return cleave::run_command_line(argc, argv, CLEAVE_VERSION,
                                  cleave::client::describe_command_line);
}
