// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/status_command.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "cleave/stream/live_options.hpp"
#include "cleave/stream/nobody_answers.hpp"
#include "cleave/stream/node_table.hpp"
#include "cleave/stream/status_reader.hpp"
#include "cleave/stream/strangers.hpp"
#include "console/terminal.hpp"

namespace cleave::client {
namespace {

struct StatusOptions {
  LiveOptions live;
  bool json = false;
  bool watch = false;
};

constexpr std::chrono::milliseconds nodes_patience{2000};
constexpr std::chrono::milliseconds discovery_time{50};  // the stream has been open for longer
constexpr std::chrono::milliseconds status_refresh_interval{1000};
constexpr const char* clear_screen = "\x1b[H\x1b[2J";

void print(const std::vector<NodeReport>& reports, const std::vector<std::string>& odd,
           const StatusOptions& options) {
  if (options.json) {
    Json nodes = Json::array();
    for (const NodeReport& report : reports) nodes.push_back(client::json_of(report));
    std::cout << one_line({{"nodes", nodes}, {"strangers", odd}}) << std::endl;
    return;
  }
  if (options.watch && is_terminal(STDOUT_FILENO)) std::cout << clear_screen;
  std::cout << node_table(reports);
  for (const std::string& line : odd) std::cout << "Stranger: " << line << '\n';
  std::cout << std::endl;
}

int run(const StatusOptions& options) {
  Shutdown shutdown;
  Stream stream(stream_options(options.live));
  StatusReader statuses(stream);
  const std::vector<NodeReport> reports = statuses.collect(shutdown, nodes_patience);
  if (reports.empty() && !shutdown.requested() && !options.watch) {
    throw std::runtime_error(nobody_answers(stream));
  }
  print(reports, strangers(discover(stream, discovery_time), reports), options);
  while (options.watch && !shutdown.wait_for(status_refresh_interval)) {
    const std::vector<NodeReport> living = statuses.living();
    print(living, strangers(discover(stream, discovery_time), living), options);
  }
  return exit_done;
}

}  // namespace

void add_status_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<StatusOptions>();
  CLI::App* command =
      app.add_subcommand("status", "State, transport, counters, rate and latency of every node");
  add_stream_options(*command, options->live);
  command->add_flag("--json", options->json,
                    "one JSON object: nodes [node, state, frames_in, ...], strangers [text]");
  command->add_flag("--watch", options->watch, "again every second, until Ctrl-C");
  command->footer(
      "Examples:\n"
      "  cleave status\n"
      "  cleave status --watch\n"
      "  cleave status --json | jq '.nodes[].frames_dropped'\n"
      "\n"
      "Names strangers: several programs that publish one topic, lists of who is not the "
      "segmenter,\n"
      "nodes of another contract. Waits up to 2 s for an answer; exits with 1 when nobody gives "
      "one.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
