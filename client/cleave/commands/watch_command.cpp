// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/watch_command.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "cleave/stream/find_sensor.hpp"
#include "cleave/stream/live_options.hpp"
#include "cleave/watch/watch_session.hpp"
#include "console/live_line.hpp"
#include "console/picture/picture.hpp"
#include "console/picture/png_file.hpp"
#include "console/segment_table.hpp"
#include "console/terminal.hpp"

namespace cleave::client {
namespace {

struct WatchOptions {
  LiveOptions live;
  std::optional<std::uint64_t> frames;
  bool json = false;
  bool quiet = false;
  std::string picture;  // empty = none
};

// A line a frame; on stderr when stdout is kept for the one JSON object.
WatchEnd follow(WatchSession& session, Shutdown& shutdown, const WatchOptions& options) {
  const int descriptor = options.json ? STDERR_FILENO : STDOUT_FILENO;
  LiveLine line(options.json ? std::cerr : std::cout,
                is_terminal(descriptor) ? terminal_columns(descriptor) : 0);
  return session.run(shutdown, options.frames, [&](const std::string& text) {
    if (!options.quiet) line.show(text);
  });
}

void write_picture(const WatchSession& session, const std::string& file) {
  const std::optional<DepthImage> image = session.last_image();
  if (!image) {
    throw std::runtime_error(file + ": not written: no cloud came with its label map");
  }
  write_png(file, side_by_side(depth_picture(*image), segment_picture(*image)));
}

void print(const WatchSession& session, const WatchOptions& options) {
  const WatchSummary summary = session.summary();
  if (options.json) {
    std::cout << one_line(json_of(summary)) << '\n';
    return;
  }
  std::cout << "\nThe last frame's segments:\n"
            << segment_table(session.last_segments()) << '\n'
            << text_of(summary);
}

int run(const WatchOptions& options) {
  Shutdown shutdown;
  Stream stream(stream_options(options.live));
  const std::string sensor =
      find_sensor(stream, shutdown, options.live.sensor, starting_sensor_patience);
  WatchSession session(stream, sensor, !options.picture.empty());
  spdlog::info("watching sensor '{}' on domain {}; Ctrl-C ends", sensor, stream.options().domain);

  const WatchEnd end = follow(session, shutdown, options);
  print(session, options);
  if (end == WatchEnd::nothing_arrives) {
    throw std::runtime_error(
        why_nothing_arrives(session.account(), sensor, stream.options().domain));
  }
  if (!options.picture.empty()) write_picture(session, options.picture);
  return exit_done;
}

}  // namespace

void add_watch_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<WatchOptions>();
  CLI::App* command =
      app.add_subcommand("watch", "A line for every frame until the stream ends, and a summary");
  add_stream_options(*command, options->live);
  add_sensor_option(*command, options->live);
  command->add_option("--frames", options->frames, "end after this many segment lists")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json,
                    "one JSON object on exit: published, segmented, dropped, rejected, ...");
  command->add_flag("--quiet", options->quiet, "no line for every frame");
  command->add_option("--picture", options->picture,
                      "PNG of the last frame: depth on the left, segments on the right");
  command->footer(
      "Examples:\n"
      "  cleave watch\n"
      "  cleave watch --sensor camera --frames 300 --json\n"
      "  cleave watch --quiet --picture last.png\n"
      "\n"
      "Ends when the source has ended and all its frames are accounted for, after --frames, on\n"
      "Ctrl-C, or with exit code 1 when no segment list comes for 30 s. The counters are those of\n"
      "the grabber and the segmenter since they were started.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
