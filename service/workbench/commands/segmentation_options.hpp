// SPDX-License-Identifier: BSD-3-Clause
// Options of the commands that segment offline.
#pragma once

#include <string>
#include <vector>

#include "console/command.hpp"
#include "segmentation/options.hpp"

namespace cleave::workbench {

struct SegmentationArguments {
  bool thesis = false;                // start from the thesis's options instead of ours
  std::string algorithm;              // empty = the default
  std::vector<std::string> settings;  // KEY=VALUE
};

// --thesis, --algorithm and --set.
void add_segmentation_options(CLI::App& command, SegmentationArguments& arguments);

// --set alone.
void add_set_option(CLI::App& command, std::vector<std::string>& settings);

// Throws UsageError for what is no option or no value of one.
[[nodiscard]] segmentation::Options options_of(const SegmentationArguments& arguments);

}  // namespace cleave::workbench
