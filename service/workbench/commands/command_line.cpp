// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/command_line.hpp"

#include <CLI/CLI.hpp>

#include "workbench/commands/bench_command.hpp"
#include "workbench/commands/evaluate_command.hpp"
#include "workbench/commands/segment_command.hpp"
#include "workbench/commands/study_command.hpp"
#include "workbench/commands/verify_command.hpp"

namespace cleave::workbench {

void describe_command_line(CLI::App& app, Action& action) {
  app.name("cleave");
  app.description("Segments clouds, and judges segments and how fast they come.");
  app.footer(
      "Examples:\n"
      "  cleave segment in.pcd out.pcd       one recorded cloud\n"
      "  cleave evaluate scenes              how good the segments of labelled clouds are\n"
      "  cleave COMMAND --help               more on each command\n"
      "\n"
      "Exit codes: 0 done, 1 failed at run time, 2 wrong usage.\n"
      "Environment: CLEAVE_LOG (trace, debug, info, warning, error).");
  app.require_subcommand(1);
  add_segment_command(app, action);
  add_verify_command(app, action);
  add_bench_command(app, action);
  add_evaluate_command(app, action);
  add_study_command(app, action);
}

}  // namespace cleave::workbench
