// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/study_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "console/progress_bar.hpp"
#include "console/table.hpp"
#include "console/terminal.hpp"
#include "recording/pcd/folder.hpp"
#include "recording/replace_file.hpp"
#include "workbench/cloud/option_setter.hpp"
#include "workbench/commands/segmentation_options.hpp"
#include "workbench/commands/trial_run.hpp"
#include "workbench/studies/eigenvectors_used.hpp"
#include "workbench/studies/plot.hpp"
#include "workbench/studies/rendered_scenes.hpp"
#include "workbench/trials/measures.hpp"

namespace cleave::workbench {
namespace {

struct StudyOptions {
  std::string name;
  std::vector<std::string> paths;  // empty = rendered scenes
  std::string output = "studies";
  std::uint32_t scenes = 20;
  std::uint32_t jobs = 1;
  std::vector<std::string> settings;
};

std::vector<Method> checked_methods(const Study& study, const StudyOptions& options) {
  try {
    return methods_of(study, options.settings);
  } catch (const OptionError& error) {
    throw UsageError(error.what());
  }
}

std::filesystem::path scenes_folder(const StudyOptions& options) {
  return std::filesystem::path(options.output) / "scenes";
}

std::vector<std::filesystem::path> scenes_of(const StudyOptions& options) {
  if (!options.paths.empty()) return recording::pcd_files(options.paths);
  return rendered_scenes(scenes_folder(options), "crowded", options.scenes);
}

std::vector<StudyPoint> points_of(const Study& study, const std::vector<Scene>& scenes) {
  std::vector<StudyPoint> points;
  for (std::size_t i = 0; i < study.x.size(); ++i) {
    const Sample sample = sample_of(scenes, i);
    points.push_back({study.x[i], sample.mean_of("under_segmentation"),
                      sample.mean_of("over_segmentation"), sample.mean_of("weighted_covering"),
                      sample.mean_of("unweighted_covering")});
  }
  return points;
}

std::string table_of(const Study& study, const std::vector<StudyPoint>& points) {
  Table table({{study.x_label, Align::right},
               {"under", Align::right},
               {"over", Align::right},
               {"weighted covering", Align::right},
               {"unweighted", Align::right}});
  for (const StudyPoint& p : points) {
    table.add_row({fmt::format("{}", p.x), fmt::format("{:.2f}", p.under),
                   fmt::format("{:.2f}", p.over), fmt::format("{:.4f}", p.weighted),
                   fmt::format("{:.4f}", p.unweighted)});
  }
  return table.to_string();
}

// Writes what there is to see, and draws it.
void write_figure(const StudyOptions& options, const std::string& figure, const std::string& data,
                  const std::string& script) {
  const auto file = (std::filesystem::path(options.output) / options.name).string();
  recording::replace_file(file + ".dat", data);
  recording::replace_file(file + ".gnuplot", script);
  draw(file + ".gnuplot");
  std::cout << fmt::format("\nFigure {} of the thesis: {}.svg, .png and .dat\n", figure, file);
}

int run_sweep(const StudyOptions& options) {
  const Study& study = *find_study(options.name);
  const TrialPlan plan{.methods = checked_methods(study, options), .jobs = options.jobs};
  recording::make_folder(options.output);
  const std::vector<Scene> scenes = try_and_warn(plan, scenes_of(options));
  const std::vector<StudyPoint> points = points_of(study, scenes);
  std::cout << table_of(study, points);
  const auto tried = std::ranges::count_if(scenes, &Scene::tried);
  write_figure(options, study.figure, data_of(study, points, static_cast<std::size_t>(tried)),
               script_of(study, points));
  return tried == std::ssize(scenes) ? exit_done : exit_failed;
}

// Half of them simple, half complex, where the user brings none.
std::vector<std::filesystem::path> simple_and_complex_scenes(const StudyOptions& options) {
  if (!options.paths.empty()) return recording::pcd_files(options.paths);
  auto files = rendered_scenes(scenes_folder(options), "simple", (options.scenes + 1) / 2);
  const auto complex = rendered_scenes(scenes_folder(options), "crowded", (options.scenes + 1) / 2);
  files.insert(files.end(), complex.begin(), complex.end());
  return files;
}

int run_eigenvectors_used(const StudyOptions& options) {
  const segmentation::Options segmentation =
      options_of({.thesis = true, .algorithm = "", .settings = options.settings});
  recording::make_folder(options.output);
  const auto files = simple_and_complex_scenes(options);
  EigenvectorsUsed used(segmentation);
  {
    ProgressBar progress(std::cerr, live_columns(STDERR_FILENO));
    for (std::size_t i = 0; i < files.size(); ++i) {
      progress.show(i, files.size());
      used.add(files[i]);
    }
  }
  for (const std::string& problem : used.problems()) spdlog::warn("skipped: {}", problem);
  if (used.problems().size() == files.size()) {
    throw std::runtime_error("no scene could be cut; the warnings above say why");
  }
  std::cout << used.table();
  write_figure(options, "5.10", used.data(), histogram_script(options.name));
  return used.problems().empty() ? exit_done : exit_failed;
}

constexpr char histogram_study[] = "eigenvectors-used";

int run(const StudyOptions& options) {
  return options.name == histogram_study ? run_eigenvectors_used(options) : run_sweep(options);
}

std::vector<std::string> names() {
  std::vector<std::string> names = {histogram_study};
  for (const Study& study : studies()) names.push_back(study.name);
  return names;
}

constexpr char explanation[] =
    "One option varies, all else is as in the thesis. Means over all scenes are printed as a\n"
    "table, and drawn with gnuplot into DIR/NAME.svg and .png, with the data in NAME.dat and the\n"
    "commands of the plot in NAME.gnuplot. Without PATH, the scenes are crowded ones, rendered\n"
    "into DIR/scenes with seeds that nothing is tuned on; they are kept for the next study.\n"
    "  cannot-link-threshold   Figure 5.9\n"
    "  eigenvectors-used       Figure 5.10: with the truth at hand, the first eigenvector of each\n"
    "                          cut that agrees with it, in scenes of up to 10 segments and of "
    "more\n"
    "  eigenvectors-single     Figure 5.11: one decomposition of the whole graph\n"
    "  eigenvectors-recursive  Figure 5.12: parts are decomposed anew\n"
    "  cannot-link-weight      Figure 5.13: constrained SSC\n"
    "\n"
    "Examples:\n"
    "  cleave study cannot-link-threshold\n"
    "  cleave study eigenvectors-single recordings --output figures --jobs 4\n"
    "  cleave study cannot-link-weight --scenes 100 --set voxel.size_m=0.006\n"
    "\n"
    "Exit codes: 0 done, 1 failed or a scene had to be skipped, 2 wrong usage.\n";

}  // namespace

void add_study_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command =
      app.add_subcommand("study", "The thesis's parameter studies anew, drawn with gnuplot");
  command->add_option("NAME", options->name, "which study, as below")
      ->required()
      ->check(CLI::IsMember(names()));
  command->add_option("PATH", options->paths,
                      "labelled PCD files, or folders of them; none: rendered scenes");
  command->add_option("--output", options->output, "folder for what is drawn and rendered")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--scenes", options->scenes, "so many rendered scenes")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command
      ->add_option("--jobs", options->jobs,
                   "scenes at a time; the results are the same (eigenvectors-used: one)")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  add_set_option(*command, options->settings);
  command->footer(explanation);
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::workbench
