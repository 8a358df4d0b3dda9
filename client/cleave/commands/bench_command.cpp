#include "cleave/commands/bench_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "cleave/cloud/pcd_cloud.hpp"
#include "cleave/cloud/pcd_folder.hpp"
#include "cleave/cloud/stage_times.hpp"
#include "cleave/commands/segmentation_options.hpp"
#include "cleave/console/progress_bar.hpp"
#include "cleave/console/terminal.hpp"

namespace cleave::client {
namespace {

using segmentation::Outcome;

struct BenchOptions {
  std::string path;
  std::uint32_t repeat = 1;
  bool json = false;
  SegmentationArguments segmentation;
};

struct Measurements {
  StageTimes times;
  std::vector<double> points;
  std::vector<double> segments;
  std::size_t skipped = 0;  // files that could not be read or segmented
};

// Times `repeat` runs over a cloud, behind an untimed one that warms the memory up.
void measure(segmentation::Segmenter& segmenter, const PcdCloud& cloud, std::uint32_t repeat,
             Measurements& measurements) {
  std::vector<std::uint16_t> labels(cloud.header().points());
  segmentation::Segmentation result;
  if (segmenter.segment(cloud.view(), labels, result) != Outcome::segmented) {
    throw PcdError("no point has finite coordinates");
  }
  for (std::uint32_t i = 0; i < repeat; ++i) {
    measurements.times.start();
    (void)segmenter.segment(cloud.view(), labels, result, &measurements.times);
    measurements.times.end_cloud();
  }
  measurements.points.push_back(static_cast<double>(cloud.header().points()));
  measurements.segments.push_back(static_cast<double>(result.segments.size()));
}

Measurements measure_all(const BenchOptions& options) {
  segmentation::Segmenter segmenter(options_of(options.segmentation));
  const std::vector<std::filesystem::path> files = pcd_files(options.path);
  ProgressBar progress(std::cerr, is_terminal(STDERR_FILENO) ? terminal_columns(STDERR_FILENO) : 0,
                       files.size());
  Measurements measurements;
  for (std::size_t i = 0; i < files.size(); ++i) {
    progress.show(i);
    try {
      measure(segmenter, PcdCloud::read(files[i]), options.repeat, measurements);
    } catch (const PcdError& error) {
      spdlog::warn("skipped: {}", error.what());
      ++measurements.skipped;
    }
  }
  if (measurements.points.empty()) {
    throw std::runtime_error(options.path + ": no cloud could be segmented");
  }
  return measurements;
}

int run(const BenchOptions& options) {
  const Measurements m = measure_all(options);
  const Percentiles points = percentiles(m.points);
  const Percentiles segments = percentiles(m.segments);
  if (options.json) {
    Json json = {{"clouds", m.points.size()}, {"skipped", m.skipped},
                 {"repeat", options.repeat},  {"threads", 1},
                 {"points", json_of(points)}, {"segments", json_of(segments)}};
    json.update(m.times.json());
    std::cout << one_line(json) << '\n';
  } else {
    std::cout << m.times.table()
              << fmt::format(
                     "{} clouds x {} runs in one thread; median {:.0f} points, {:.0f} "
                     "segments a cloud\n",
                     m.points.size(), options.repeat, points.median, segments.median);
  }
  return exit_done;
}

}  // namespace

void add_bench_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command =
      app.add_subcommand("bench", "Time of the segmentation by stage, in one thread");
  command->add_option("FILE_OR_DIR", options->path, "PCD file, or a folder of them")->required();
  command->add_option("--repeat", options->repeat, "timed runs a cloud, behind one untimed")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "one JSON object: total_ms, stages_ms, points, ...");
  add_segmentation_options(*command, options->segmentation);
  command->footer(
      "Examples:\n"
      "  cleave bench in.pcd --repeat 20\n"
      "  cleave bench recordings --json | jq .total_ms.median");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
