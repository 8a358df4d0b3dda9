// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/record_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cleave/commands/finite_number.hpp"
#include "cleave/record/record_session.hpp"
#include "cleave/stream/find_sensor.hpp"
#include "cleave/stream/live_options.hpp"
#include "cleave/stream/topic_names.hpp"
#include "console/live_line.hpp"
#include "console/terminal.hpp"
#include "recording/sources/frame_sink.hpp"

namespace cleave::client {
namespace {

struct RecordOptions {
  LiveOptions live;
  std::string output;
  std::vector<std::string> topics;
  std::optional<double> duration_s;
  std::optional<std::uint64_t> max_size_mb;
};

constexpr std::chrono::milliseconds record_refresh_interval{250};
constexpr double bytes_per_mb = 1e6;

std::string counts_of(const RecordingState& state, const RecordSession& session) {
  std::string text;
  std::uint64_t dropped = 0;
  for (const auto& [kind, count] : state.written)
    text += fmt::format("  {} {}", topic_of(kind), count);
  for (const auto& [kind, count] : state.dropped) dropped += count;
  return text + fmt::format("  dropped {}  lost {}", dropped, session.lost_clouds());
}

std::string progress(const RecordingState& state, const RecordSession& session) {
  const double elapsed_s = session.elapsed_s();
  const double mb = static_cast<double>(state.file_bytes) / bytes_per_mb;
  return fmt::format("{:.0f} s  {:.1f} MB  {:.1f} MB/s{}  disk left {:.1f} GB", elapsed_s, mb,
                     elapsed_s > 0 ? mb / elapsed_s : 0.0, counts_of(state, session),
                     static_cast<double>(state.disk_left_bytes) / 1e9);
}

RecordingLimits limits_of(const RecordOptions& options) {
  RecordingLimits limits;
  if (options.max_size_mb) limits.max_file_bytes = *options.max_size_mb * 1'000'000;
  return limits;
}

// Returns why it stopped.
std::string record(RecordSession& session, BackgroundWriter& writer, Shutdown& shutdown,
                   const RecordOptions& options) {
  const bool terminal = is_terminal(STDERR_FILENO);
  LiveLine line(std::cerr, live_columns(STDERR_FILENO));
  auto next_line = std::chrono::steady_clock::now();
  return session.run(shutdown, options.duration_s, [&] {
    if (!terminal || std::chrono::steady_clock::now() < next_line) return;
    next_line += record_refresh_interval;
    line.show(progress(writer.state(), session));
  });
}

int run(const RecordOptions& options) {
  const std::set<recording::Kind> topics = kinds_of(options.topics);
  recording::refuse_existing(options.output);
  recording::refuse_without_folder(options.output);
  Shutdown shutdown;
  Stream stream(stream_options(options.live));
  const std::string sensor =
      find_sensor(stream, shutdown, options.live.sensor, starting_sensor_patience);
  BackgroundWriter writer(options.output, limits_of(options));
  RecordSession session(stream, sensor, topics, writer);
  spdlog::info("recording sensor '{}' into {}; Ctrl-C ends", sensor, options.output);

  const std::string reason = record(session, writer, shutdown, options);
  writer.finish({{"sensor", sensor},
                 {"ended", reason},
                 {"lost cloud", std::to_string(session.lost_clouds())}});
  const RecordingState state = writer.state();
  std::cout << fmt::format("{}: {:.1f} MB{}; {}\n", options.output,
                           static_cast<double>(state.file_bytes) / bytes_per_mb,
                           counts_of(state, session), reason);
  return state.failed ? exit_failed : exit_done;
}

}  // namespace

void add_record_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command = app.add_subcommand("record", "The live stream into an MCAP file");
  command->add_option("OUTPUT", options->output, "MCAP file to write; must not exist")->required();
  add_stream_options(*command, options->live);
  add_sensor_option(*command, options->live);
  command->add_option("--topics", options->topics, "cloud, labels, segments; all by default")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--duration", options->duration_s, "end so many seconds after the first frame")
      ->check(finite_number());
  command->add_option("--max-size", options->max_size_mb, "end when the file has so many megabytes")
      ->check(CLI::PositiveNumber);
  command->footer(
      "Examples:\n"
      "  cleave record run.mcap\n"
      "  cleave record --topics cloud --duration 60 run.mcap\n"
      "\n"
      "Ends on Ctrl-C, when the source has ended, or when 256 MB are left on the disk, and always\n"
      "with a complete file; if it is killed, `cleave recover` gives back all but the last "
      "second.\n"
      "The stream never waits: where the disk is too slow, whole frames are dropped, counted here\n"
      "and in the file. Clouds of a camera are stored as depth images, which Foxglove, Lichtblick\n"
      "and Rerun show, and come back bit for bit; all others as they are.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
