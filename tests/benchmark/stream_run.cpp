// SPDX-License-Identifier: BSD-3-Clause
#include "tests/benchmark/stream_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/integration/support/daemons.hpp"

namespace cleave::benchmark {
namespace {

using test::Daemons;
using test::Process;
using Json = nlohmann::json;

constexpr std::uint32_t domain = 23;
constexpr std::chrono::minutes patience{3};

std::string camera_name(unsigned index) {
  return "camera" + std::to_string(index + 1);
}

// utime and stime follow the name, which is in parentheses, and 11 more fields.
double cpu_time_s(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text, ')');
  for (int i = 0; i < 11; ++i) file >> text;
  double user = 0, system = 0;
  file >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::string configuration(const StreamSetting& setting) {
  std::string sensors;
  for (unsigned i = 0; i < setting.cameras; ++i) sensors += (i ? ", " : "") + camera_name(i);
  return "sensors: [" + sensors + "]\nworkers: " + std::to_string(setting.workers) +
         "\nqueue: " + std::to_string(setting.queue) + "\n";
}

Json output_of(Process& process) {
  if (process.wait(patience) != 0) throw std::runtime_error("a run failed: " + process.log());
  return Json::parse(process.output());
}

void add_camera(StreamFigures& figures, const Json& watched, unsigned fps) {
  const auto published = watched["published"].get<std::uint64_t>();
  const auto dropped = watched["dropped"].get<std::uint64_t>();
  figures.published += published;
  figures.dropped += dropped;
  for (const auto& [cause, count] : watched["dropped_by_cause"].items()) {
    figures.dropped_by_cause[cause] += count.get<std::uint64_t>();
  }
  figures.published_hz += fps;
  figures.segmented_hz += watched["fps"].get<double>();
  figures.latency_median_ms =
      std::max(figures.latency_median_ms, watched["latency_ms"]["median"].get<double>());
  figures.latency_p99_ms =
      std::max(figures.latency_p99_ms, watched["latency_ms"]["p99"].get<double>());
  figures.segmenter_cpu = std::max(figures.segmenter_cpu, watched["segmenter_cpu"].get<double>());
}

}  // namespace

StreamFigures run_stream(const StreamSetting& setting, unsigned seconds) {
  const Daemons daemons(domain, true);
  const test::TemporaryFolder folder;
  const std::string config = (folder.path() / "segmenter.yaml").string();
  std::ofstream(config) << configuration(setting);
  Process segmenter = daemons.run("cleave-segmenter", {"--config", config});
  if (!segmenter.logs("ready")) throw std::runtime_error("not ready: " + segmenter.log());

  std::vector<Process> watches, grabbers;
  for (unsigned i = 0; i < setting.cameras; ++i) {
    watches.push_back(
        daemons.run("cleave", {"watch", "--json", "--quiet", "--sensor", camera_name(i)}));
    (void)watches.back().logs("watching");
  }
  for (unsigned i = 0; i < setting.cameras; ++i) {
    grabbers.push_back(daemons.grabber(
        setting.source, {"--loop", "--sensor", camera_name(i), "--fps", std::to_string(setting.fps),
                         "--frames", std::to_string(setting.fps * seconds)}));
  }
  Process stages = daemons.run("cleave", {"hz", "--latency", "--json", "--sensor", camera_name(0),
                                          "--duration", std::to_string(seconds - 2)});
  const double cpu_before_s = cpu_time_s(grabbers[0].id());
  StreamFigures figures;
  const Json stage_figures = output_of(stages);
  figures.grabber_cpu = (cpu_time_s(grabbers[0].id()) - cpu_before_s) / (seconds - 2);
  for (const auto& [stage, figure] : stage_figures["stages_ms"].items()) {
    figures.stage_median_ms[stage] = figure["median"].get<double>();
  }
  for (Process& watch : watches) add_camera(figures, output_of(watch), setting.fps);
  return figures;
}

}  // namespace cleave::benchmark
