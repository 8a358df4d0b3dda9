// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/command_line.hpp"

#include <CLI/CLI.hpp>

#include "cleave/commands/convert_command.hpp"
#include "cleave/commands/echo_command.hpp"
#include "cleave/commands/hz_command.hpp"
#include "cleave/commands/info_command.hpp"
#include "cleave/commands/list_command.hpp"
#include "cleave/commands/record_command.hpp"
#include "cleave/commands/recover_command.hpp"
#include "cleave/commands/replay_command.hpp"
#include "cleave/commands/status_command.hpp"
#include "cleave/commands/watch_command.hpp"
#include "cleave/commands/workbench_commands.hpp"

namespace cleave::client {

void describe_command_line(CLI::App& app, Action& action) {
  app.name("cleave");
  app.description(
      "Looks at a stream of depth segments, records and replays it, and segments clouds.");
  app.footer(
      "Examples:\n"
      "  cleave status                       what runs, and how well\n"
      "  cleave watch                        every frame of the only sensor, until it ends\n"
      "  cleave record run.mcap              the live stream into a file\n"
      "  cleave segment in.pcd out.pcd       one recorded cloud\n"
      "  cleave evaluate scenes              how good the segments of labelled clouds are\n"
      "  cleave COMMAND --help               more on each command\n"
      "\n"
      "Exit codes: 0 done, 1 failed at run time, 2 wrong usage.\n"
      "Environment: CLEAVE_DOMAIN (0 to 99), CLEAVE_INTERFACE (a network interface),\n"
      "CLEAVE_LOG (trace, debug, info, warning, error).");
  app.require_subcommand(1);
  add_status_command(app, action);
  add_watch_command(app, action);
  add_echo_command(app, action);
  add_hz_command(app, action);
  add_list_command(app, action);
  add_record_command(app, action);
  add_replay_command(app, action);
  add_info_command(app, action);
  add_convert_command(app, action);
  add_recover_command(app, action);
  add_workbench_commands(app);
}

}  // namespace cleave::client
