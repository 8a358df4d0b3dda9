// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/evaluate_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>

#include "console/unit_option.hpp"
#include "recording/pcd/folder.hpp"
#include "recording/replace_file.hpp"
#include "workbench/cloud/option_setter.hpp"
#include "workbench/commands/segmentation_options.hpp"
#include "workbench/commands/trial_run.hpp"
#include "workbench/trials/csv.hpp"
#include "workbench/trials/report.hpp"

namespace cleave::workbench {
namespace {

struct EvaluateOptions {
  std::vector<std::string> paths;
  std::vector<std::string> algorithms = {"ssc"};
  std::vector<std::string> settings;
  std::uint32_t grid_offsets = 1;
  std::uint32_t jobs = 1;
  std::string groups;
  std::string csv;       // empty = none
  std::string pictures;  // empty = none
  UnitArgument unit;
  bool json = false;
};

std::vector<Method> methods_of(const EvaluateOptions& options) {
  std::vector<Method> methods;
  std::set<std::string> names;
  for (const std::string& name : options.algorithms) {
    if (!names.insert(name).second) throw UsageError("--algorithm " + name + " is given twice");
    try {
      methods.push_back(method_named(name, options.settings));
    } catch (const OptionError& error) {
      throw UsageError(error.what());
    }
  }
  return methods;
}

// Found out before the work, not behind it.
void prepare_outputs(const EvaluateOptions& options) {
  if (!options.pictures.empty()) recording::make_folder(options.pictures);
  if (options.csv.empty()) return;
  const auto folder = std::filesystem::absolute(options.csv).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error(options.csv + ": there is no folder " + folder.string() +
                             "; make it, or name another file");
  }
}

std::vector<Group> groups_of(const EvaluateOptions& options, std::size_t scenes) {
  try {
    return parse_groups(options.groups, scenes);
  } catch (const GroupError& error) {
    throw UsageError(std::string("--groups: ") + error.what());
  }
}

TrialResult evaluate(const EvaluateOptions& options) {
  const TrialPlan plan{.methods = methods_of(options),
                       .grid_offsets = options.grid_offsets,
                       .jobs = options.jobs,
                       .pictures = options.pictures,
                       .unit = options.unit.unit()};
  const auto files = recording::pcd_files(options.paths);
  TrialResult result;
  result.groups = groups_of(options, files.size());
  for (const Method& method : plan.methods) result.methods.push_back(method.name);
  prepare_outputs(options);
  result.scenes = try_and_warn(plan, files);
  return result;
}

int run(const EvaluateOptions& options) {
  const TrialResult result = evaluate(options);
  if (options.json) {
    Json json = workbench::json_of(result);
    json["grid_offsets"] = options.grid_offsets;
    std::cout << one_line(json) << '\n';
  } else {
    std::cout << text_of(result);
  }
  if (!options.csv.empty()) recording::replace_file(options.csv, csv_of(result));
  return result.skipped() == 0 ? exit_done : exit_failed;
}

constexpr char evaluate_examples[] =
    "PATH holds PCD files, organised or not, with the field label (uint32, 0 = not counted). Only\n"
    "measured points count; a point that an algorithm leaves without a label counts for its "
    "nearest\n"
    "labelled one. Coverings, under- and over-segmentation are those of section 5.2 of the "
    "thesis;\n"
    "boundary F counts borders in the image as found within 0.8 % of its diagonal; objects are\n"
    "found where the intersection over union is above 0.75. Times are those that the thread had a\n"
    "core for. min is the worst single run.\n"
    "  thesis          the thesis's plain SSC: its values, no clean-up, no refinement\n"
    "  thesis-NAME     another algorithm of ours with the thesis's values\n"
    "  lccp            PCL's supervoxels and LCCP, with the values that were published\n"
    "  lccp-tuned      the same with the best values that we know for tables\n"
    "  cpc             PCL's supervoxels and CPC, with the values of PCL's example\n"
    "PCL's grid cannot be shifted: its methods run once a scene, and their labels may differ a\n"
    "little from run to run. --set is for ours.\n"
    "\n"
    "Examples:\n"
    "  cleave evaluate scenes\n"
    "  cleave evaluate scenes --algorithm ssc,thesis,lccp,lccp-tuned,cpc --jobs 4\n"
    "  cleave evaluate scenes --grid-offsets 4 --json | jq .weighted_covering.mean\n"
    "  cleave evaluate scenes --groups 0-15,16-44 --csv runs.csv --pictures sheets\n"
    "  cleave evaluate scenes --set graph.cannot_link_rad=0.8\n"
    "\n"
    "Exit codes: 0 done, 1 failed or a scene had to be skipped, 2 wrong usage.\n";

}  // namespace

void add_evaluate_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command =
      app.add_subcommand("evaluate", "How good segmentations are on labelled clouds, side by side");
  command->add_option("PATH", options->paths, "PCD files, or folders of them")->required();
  command
      ->add_option("--algorithm", options->algorithms,
                   "what to evaluate, a comma between two: " + method_names())
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  add_set_option(*command, options->settings);
  add_unit_option(*command, options->unit);
  command
      ->add_option("--grid-offsets", options->grid_offsets,
                   "segment each scene on so many shifts of the grid over one voxel")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "scenes at a time; the results are the same")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command
      ->add_option("--groups", options->groups,
                   "also sum up these scenes, numbered from 0 in natural order of the files")
      ->type_name("0-15,16-23,...");
  command->add_option("--csv", options->csv, "a line a run, for spreadsheets")->type_name("FILE");
  command
      ->add_option("--pictures", options->pictures,
                   "a PNG a scene: input and truth, then a row an algorithm: result, difference "
                   "(green, red)")
      ->type_name("DIR");
  command->add_flag("--json", options->json,
                    "one JSON object: weighted_covering.mean, .., milliseconds.median, "
                    "algorithms, per_scene");
  command->footer(evaluate_examples);
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::workbench
