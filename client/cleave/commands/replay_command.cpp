// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/replay_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "cleave/commands/finite_number.hpp"
#include "cleave/record/background_writer.hpp"
#include "cleave/replay/replay_session.hpp"
#include "cleave/stream/live_options.hpp"
#include "cleave/stream/topic_names.hpp"
#include "console/live_line.hpp"
#include "console/terminal.hpp"
#include "libcleave/discovery.hpp"

namespace cleave::client {
namespace {

struct ReplayOptions {
  LiveOptions live;
  std::string input;
  std::vector<std::string> topics;
  double rate = 1;
  double max_gap_s = recording::GapLimit::default_s;
  bool as_fast_as_possible = false;
  bool loop = false;
  bool once = false;
  double start_s = 0;
  std::optional<double> end_s;
  bool lossless = false;
};

constexpr std::uint32_t lossless_window = 4;
constexpr std::chrono::milliseconds replay_discovery_time{1000};
constexpr std::chrono::milliseconds replay_refresh_interval{250};

std::set<recording::Kind> selected_kinds(const ReplayOptions& options) {
  if (!options.lossless) return kinds_of(options.topics);
  if (options.topics.empty()) return {recording::Kind::cloud};
  std::set<recording::Kind> kinds = kinds_of(options.topics);
  if (kinds != std::set{recording::Kind::cloud}) {
    throw UsageError(
        "--lossless replays clouds to a live segmenter, whose results are not replayed: add "
        "--topics cloud");
  }
  return kinds;
}

ReplayPlan plan_of(const ReplayOptions& options) {
  if (options.end_s && *options.end_s <= options.start_s) {
    throw UsageError("--end must be after --start");
  }
  ReplayPlan plan;
  plan.file = options.input;
  plan.selection = {selected_kinds(options), options.live.sensor, options.start_s, options.end_s};
  plan.rate = options.as_fast_as_possible ? 0 : options.rate;
  plan.max_gap_s = options.max_gap_s;
  plan.loop = options.loop;
  if (options.lossless) plan.window = lossless_window;
  return plan;
}

// Labels from two sides would contradict each other.
void refuse_two_segmenters(Stream& stream, const std::set<recording::Kind>& kinds,
                           const std::string& sensor) {
  for (const Endpoint& endpoint : discover(stream, replay_discovery_time)) {
    const bool results =
        (kinds.contains(recording::Kind::labels) && endpoint.topic.ends_with("/labels")) ||
        (kinds.contains(recording::Kind::segments) && endpoint.topic.ends_with("/segments"));
    const bool same = sensor.empty() || endpoint.topic.starts_with("cleave/" + sensor + "/");
    if (!endpoint.writes || !results || !same) continue;
    throw std::runtime_error("a segmenter publishes " + endpoint.topic +
                             " already: replay the clouds alone (--topics cloud), or end it");
  }
}

std::string counts_of(const ReplaySession& session) {
  std::string text;
  for (const auto& [kind, count] : session.published()) {
    text += fmt::format("  {} {}", topic_of(kind), count);
  }
  return text;
}

void replay(ReplaySession& session, Shutdown& shutdown) {
  const bool terminal = is_terminal(STDERR_FILENO);
  LiveLine line(std::cerr, live_columns(STDERR_FILENO));
  auto next_line = std::chrono::steady_clock::now();
  session.run(shutdown, [&] {
    if (!terminal || std::chrono::steady_clock::now() < next_line) return;
    next_line += replay_refresh_interval;
    line.show(session.published().empty()
                  ? "waiting for a reader"
                  : fmt::format("{:.1f} s{}", session.position_s(), counts_of(session)));
  });
  line.erase();
}

int run(const ReplayOptions& options) {
  const ReplayPlan plan = plan_of(options);
  Shutdown shutdown;
  Stream stream(stream_options(options.live));
  ReplaySession session(stream, plan);
  refuse_two_segmenters(stream, plan.selection.kinds, options.live.sensor);
  spdlog::info("replaying {}; Ctrl-C ends", options.input);
  replay(session, shutdown);
  std::cout << fmt::format("{}:{}  {:.1f} Hz\n", options.input, counts_of(session),
                           session.mean_rate_hz());
  for (const std::string& problem : session.problems()) {
    spdlog::warn("{}: damaged: {}", options.input, problem);
  }
  if (session.published().empty() && !shutdown.requested()) {
    throw std::runtime_error(options.input +
                             ": holds no such frame; `cleave info` says what it holds");
  }
  return session.problems().empty() ? exit_done : exit_failed;
}

}  // namespace

void add_replay_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "A recording back onto the stream");
  command->add_option("INPUT", options->input, "MCAP file of `cleave record`")->required();
  add_stream_options(*command, options->live);
  add_sensor_option(*command, options->live);
  command->add_option("--topics", options->topics, "cloud, labels, segments; all by default")
      ->delimiter(',')
      ->allow_extra_args(false);
  auto* rate = command->add_option("--rate", options->rate, "times as fast as recorded; 1")
                   ->check(finite_number());
  command->add_flag("--as-fast-as-possible", options->as_fast_as_possible, "without any pause")
      ->excludes(rate);
  command
      ->add_option("--max-gap", options->max_gap_s,
                   "longest pause between two frames, in seconds of the recording; 1")
      ->check(finite_number(true))
      ->check(CLI::Range(0.0, 86'400.0));
  auto* once = command->add_flag("--once", options->once, "end after the last frame: the default");
  command->add_flag("--loop", options->loop, "begin again after the last frame")->excludes(once);
  command->add_option("--start", options->start_s, "seconds from the beginning")
      ->check(finite_number(true));
  command->add_option("--end", options->end_s, "seconds from the beginning")
      ->check(finite_number());
  command->add_flag("--lossless", options->lossless,
                    "clouds to a live segmenter; the next one when segment lists have come back");
  command->footer(
      "Examples:\n"
      "  cleave replay run.mcap\n"
      "  cleave replay --topics cloud --loop run.mcap       the live segmenter segments again\n"
      "  cleave replay --lossless --as-fast-as-possible run.mcap\n"
      "\n"
      "Where the recording's clock jumps, by days or backwards, it plays on after --max-gap at\n"
      "most, and says so once.\n"
      "What is published equals what was recorded, epochs and frame ids included; only the\n"
      "times of arrival and publication are new, and epochs rise when a loop begins again. Waits\n"
      "for a first reader. Recorded labels and segments are refused while a segmenter publishes\n"
      "its own.\n"
      "Exit code 1: part of the file is damaged and was left out.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
