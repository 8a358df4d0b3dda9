// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/bench_command.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "console/progress_bar.hpp"
#include "console/terminal.hpp"
#include "console/unit_option.hpp"
#include "recording/pcd/folder.hpp"
#include "workbench/bench/bench_report.hpp"
#include "workbench/bench/growth.hpp"
#include "workbench/commands/segmentation_options.hpp"

namespace cleave::workbench {
namespace {

struct BenchOptions {
  std::vector<std::string> paths;
  std::string against;  // empty = nothing
  std::uint32_t repeat = 1;
  std::uint32_t grid_offsets = 1;
  bool growth = false;
  bool collapse = false;
  bool json = false;
  UnitArgument unit;
  SegmentationArguments segmentation;
};

BenchPlan plan_of(const BenchOptions& options) {
  return {.options = options_of(options.segmentation),
          .repeat = options.repeat,
          .grid_offsets = options.grid_offsets,
          .against_pcl = options.against == "pcl",
          .find_collapses = options.collapse};
}

// `Measurer`: Bench or Growth. Returns how many files had to be left out.
template <class Measurer>
std::size_t measure_all(const BenchOptions& options, Measurer& measurer) {
  const std::vector<std::filesystem::path> files = recording::pcd_files(options.paths);
  std::size_t skipped = 0;
  {
    ProgressBar progress(std::cerr, live_columns(STDERR_FILENO));
    for (std::size_t i = 0; i < files.size(); ++i) {
      progress.show(i, files.size());
      try {
        measurer.measure(files[i].string(), evaluation::load_cloud(files[i], options.unit.unit()));
      } catch (const std::runtime_error& error) {
        spdlog::warn("skipped: {}", error.what());
        ++skipped;
      }
    }
  }
  if (skipped == files.size()) {
    throw std::runtime_error("no cloud could be segmented; the warnings above say why");
  }
  return skipped;
}

int run_growth(const BenchOptions& options) {
  Growth growth(plan_of(options));
  const std::size_t skipped = measure_all(options, growth);
  if (options.json) {
    Json json = growth.json();
    json["skipped"] = skipped;
    std::cout << one_line(json) << '\n';
  } else {
    std::cout << growth.text();
  }
  return exit_done;
}

int run_bench(const BenchOptions& options) {
  Bench bench(plan_of(options));
  const std::size_t skipped = measure_all(options, bench);
  const BenchResult& result = bench.result();
  if (options.json) {
    Json json = json_of(result);
    json.update({{"skipped", skipped},
                 {"repeat", options.repeat},
                 {"grid_offsets", options.grid_offsets},
                 {"threads", 1}});
    if (options.collapse) json["collapses"] = collapse_json(result);
    std::cout << one_line(json) << '\n';
  } else {
    std::cout << text_of(result);
    if (options.collapse) std::cout << '\n' << collapse_text(result);
  }
  const bool sound = result.collapses.empty();
  return options.collapse && (!sound || result.ours.qualities.empty()) ? exit_failed : exit_done;
}

void check(const BenchOptions& options) {
  if (options.growth && (!options.against.empty() || options.collapse)) {
    throw UsageError(
        "--growth measures the segmentation alone; leave --against and --collapse out");
  }
}

constexpr char examples[] =
    "A cloud is segmented once untimed, then --repeat times; with --against pcl, on each cloud "
    "all\n"
    "methods take turns, one thread each. Times are those that the thread had a core for, so that\n"
    "other programs do not count. A ratio is the other method's median over ours.\n"
    "  pcl_ssc         PCL's supervoxels (7.5 mm voxels, 30 mm seeds), our graph and partition\n"
    "  pcl_lccp        PCL's supervoxels and LCCP, with the values that were published\n"
    "  pcl_lccp_tuned  the same with the best values that we know for tables\n"
    "Where clouds have the field label (uint32), the coverings of section 5.2 of the thesis stand\n"
    "in the same table; points that a method leaves unlabelled count for their nearest neighbour.\n"
    "Allocations are those of a timed run: new, malloc and their kin, in all libraries.\n"
    "\n"
    "Examples:\n"
    "  cleave bench in.pcd --repeat 20\n"
    "  cleave bench recordings --against pcl\n"
    "  cleave bench recordings --json | jq .milliseconds.median\n"
    "  cleave bench recordings --grid-offsets 12 --collapse     fails if any run goes badly wrong\n"
    "  cleave bench recordings --growth                         a quarter to 4 times the points\n";

}  // namespace

void add_bench_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand(
      "bench", "Time of the segmentation by stage, and its quality, beside PCL's");
  command->add_option("PATH", options->paths, "PCD files, or folders of them")->required();
  command->add_option("--against", options->against, "what to compare with, in the same run")
      ->check(CLI::IsMember({"pcl"}));
  command->add_option("--repeat", options->repeat, "timed runs a cloud, behind one untimed")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command
      ->add_option("--grid-offsets", options->grid_offsets,
                   "segment each cloud on so many shifts of the grid over one voxel")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--collapse", options->collapse,
                    "list runs below 0.90 weighted covering where the thesis's plain method\n"
                    "reaches 0.97; exit code 1 if there is one");
  command->add_flag("--growth", options->growth,
                    "the same clouds with 1/4, 1 and 4 times the points, and the exponent of cost");
  command->add_flag("--json", options->json,
                    "one JSON object: scenes, milliseconds, stages, weighted_covering, ratio, ...");
  add_unit_option(*command, options->unit);
  add_segmentation_options(*command, options->segmentation);
  command->footer(examples);
  command->callback([options, &action] {
    action = [options] {
      check(*options);
      return options->growth ? run_growth(*options) : run_bench(*options);
    };
  });
}

}  // namespace cleave::workbench
