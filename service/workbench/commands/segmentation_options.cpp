// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/segmentation_options.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "segmentation/option_checks.hpp"
#include "workbench/cloud/option_setter.hpp"

namespace cleave::workbench {

void add_segmentation_options(CLI::App& command, SegmentationArguments& arguments) {
  command.add_flag("--thesis", arguments.thesis,
                   "start from the options of the thesis, not from ours");
  command.add_option("--algorithm", arguments.algorithm, "same as --set algorithm=...");
  add_set_option(command, arguments.settings);
}

void add_set_option(CLI::App& command, std::vector<std::string>& settings) {
  command.add_option("--set", settings, "an option of the segmentation; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);  // one each: what follows may be the files
}

segmentation::Options options_of(const SegmentationArguments& arguments) {
  const segmentation::Options preset =
      arguments.thesis ? segmentation::thesis() : segmentation::Options{};
  segmentation::Options options = preset;
  try {
    if (!arguments.algorithm.empty()) set_option(options, "algorithm=" + arguments.algorithm);
    for (const std::string& setting : arguments.settings) set_option(options, setting);
    segmentation::check_options(options, preset);
  } catch (const OptionError& error) {
    throw UsageError(error.what());
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  return options;
}

}  // namespace cleave::workbench
