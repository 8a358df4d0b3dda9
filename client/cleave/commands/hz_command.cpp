// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/hz_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cleave/commands/finite_number.hpp"
#include "cleave/stream/find_sensor.hpp"
#include "cleave/stream/list_arrival.hpp"
#include "cleave/stream/live_options.hpp"
#include "console/json.hpp"
#include "console/live_line.hpp"
#include "console/table.hpp"
#include "console/terminal.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"

namespace cleave::client {
namespace {

using Clock = std::chrono::steady_clock;

struct HzOptions {
  LiveOptions live;
  std::uint64_t frames = 0;  // 0 = no limit
  double duration_s = 0;     // 0 = no limit
  bool latency = false;
  bool json = false;
};

constexpr std::chrono::seconds hz_refresh_interval{1};

std::string text_of(const StreamSummary& summary, double rate_hz) {
  const Percentiles latency_ms = summary.latency_ms();
  return fmt::format("{:.2f} Hz  latency median {:.1f} p90 {:.1f} p99 {:.1f} ms  {} lists  {} gaps",
                     rate_hz, latency_ms.median, latency_ms.p90, latency_ms.p99, summary.lists(),
                     summary.gaps());
}

std::string stage_table(const StreamSummary& summary) {
  Table table({{"stage", Align::left},
               {"median [ms]", Align::right},
               {"p90 [ms]", Align::right},
               {"p99 [ms]", Align::right}});
  const auto add_row = [&table](const char* stage, const Percentiles& p) {
    table.add_row({stage, fmt::format("{:.2f}", p.median), fmt::format("{:.2f}", p.p90),
                   fmt::format("{:.2f}", p.p99)});
  };
  for (std::size_t stage = 0; stage < latency_stages.size(); ++stage) {
    add_row(latency_stages.at(stage), summary.stage_ms(stage));
  }
  add_row("all", summary.total_ms());
  return table.to_string();
}

Json json_of(const StreamSummary& summary, const std::string& sensor) {
  Json stages = Json::object();
  for (std::size_t stage = 0; stage < latency_stages.size(); ++stage) {
    stages[latency_stages.at(stage)] = cleave::json_of(summary.stage_ms(stage));
  }
  return {{"sensor", sensor},
          {"rate_hz", summary.mean_rate_hz()},
          {"latency_ms", cleave::json_of(summary.latency_ms())},
          {"stages_ms", stages},
          {"total_ms", cleave::json_of(summary.total_ms())},
          {"lists", summary.lists()},
          {"gaps", summary.gaps()}};
}

// Until the limit or a signal.
StreamSummary measure(Reader<SegmentList>& lists, Shutdown& shutdown, const HzOptions& options) {
  const bool terminal = is_terminal(STDOUT_FILENO);
  LiveLine line(std::cout, terminal ? terminal_columns(STDOUT_FILENO) : 0);
  WaitSet wait_set;
  wait_set.attach(lists);
  StreamSummary summary;
  const Clock::time_point start = Clock::now();
  Clock::time_point next_line = start + hz_refresh_interval;
  while (!shutdown.requested()) {
    (void)wait_set.wait(longest_wait);
    while (const auto list = lists.take()) {
      summary.add(arrival_of(**list, Clock::now()));
      if (summary.lists() == options.frames) return summary;
    }
    const Clock::time_point now = Clock::now();
    const double elapsed_s = std::chrono::duration<double>(now - start).count();
    if (options.duration_s > 0 && elapsed_s >= options.duration_s) return summary;
    if (now < next_line) continue;
    next_line = now + hz_refresh_interval;
    if (!options.json) line.show(text_of(summary, summary.recent_rate_hz()));
  }
  return summary;
}

int run(const HzOptions& options) {
  Shutdown shutdown;
  Stream stream(stream_options(options.live));
  const std::string sensor = find_sensor(stream, shutdown, options.live.sensor, sensor_patience);
  Reader<SegmentList> lists(stream, sensor);
  spdlog::info("measuring segment lists of sensor '{}'; Ctrl-C ends", sensor);
  const StreamSummary summary = measure(lists, shutdown, options);
  if (options.json) {
    std::cout << one_line(json_of(summary, sensor)) << '\n';
  } else {
    std::cout << text_of(summary, summary.mean_rate_hz()) << '\n';
    if (options.latency) std::cout << stage_table(summary);
  }
  return exit_done;
}

}  // namespace

void add_hz_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<HzOptions>();
  CLI::App* command = app.add_subcommand(
      "hz", "Rate, gaps, and latency from the publication of a cloud to its segments in hand");
  add_stream_options(*command, options->live);
  add_sensor_option(*command, options->live);
  auto* frames = command->add_option("--frames", options->frames, "end after this many lists")
                     ->check(CLI::PositiveNumber);
  command->add_option("--duration", options->duration_s, "end after this many seconds")
      ->check(finite_number())
      ->excludes(frames);
  command->add_flag("--latency", options->latency,
                    "also the latency by stage, from the frame in the grabber's hands: in the "
                    "grabber, in transport, waiting for a worker, segmenting, publishing (in "
                    "frame order), delivery to this client");
  command->add_flag("--json", options->json,
                    "one JSON object: rate_hz, latency_ms, stages_ms, total_ms, lists, gaps");
  command->footer(
      "Examples:\n"
      "  cleave hz\n"
      "  cleave hz --latency --frames 300\n"
      "  cleave hz --sensor camera --duration 10 --json");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
