// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/echo_command.hpp"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cleave/stream/contract_frames.hpp"
#include "cleave/stream/find_sensor.hpp"
#include "cleave/stream/live_options.hpp"
#include "cleave/stream/segment_message.hpp"
#include "console/contract_json.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"

namespace cleave::client {
namespace {

struct EchoOptions {
  LiveOptions live;
  std::uint64_t frames = 0;  // 0 = no limit
  bool json = false;
};

int run(const EchoOptions& options) {
  Shutdown shutdown;
  Stream stream(stream_options(options.live));
  const std::string sensor = find_sensor(stream, shutdown, options.live.sensor, sensor_patience);
  Reader<SegmentList> lists(stream, sensor);
  WaitSet wait_set;
  wait_set.attach(lists);
  spdlog::info("waiting for segment lists of sensor '{}'; Ctrl-C ends", sensor);

  std::uint64_t printed = 0;
  while (!shutdown.requested()) {
    (void)wait_set.wait(longest_wait);
    while (const auto list = lists.take()) {
      const recording::SegmentList frame = frame_of(**list);
      std::cout << (options.json ? one_line(contract_json(frame)) + '\n' : text_of(frame))
                << std::flush;
      if (++printed == options.frames) return exit_done;
    }
  }
  return exit_done;
}

}  // namespace

void add_echo_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<EchoOptions>();
  CLI::App* command = app.add_subcommand("echo", "Segment lists as text or JSON");
  add_stream_options(*command, options->live);
  add_sensor_option(*command, options->live);
  command->add_option("--frames", options->frames, "end after this many lists")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "one JSON object a line, keys as in the contract");
  command->footer(
      "Examples:\n"
      "  cleave echo --frames 1\n"
      "  cleave echo --sensor camera --json | jq '.segments | length'");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
