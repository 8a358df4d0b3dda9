// SPDX-License-Identifier: BSD-3-Clause
// The commands that segment and judge. They are a program of their own, cleave-workbench, so that a
// robot that only looks at its stream needs neither the segmentation nor PCL; people call them as
// `cleave COMMAND` all the same.
#pragma once

#include <array>
#include <string_view>

#include "console/command.hpp"

namespace cleave::client {

struct WorkbenchCommand {
  std::string_view name;
  std::string_view description;  // as the workbench's own
};

inline constexpr std::array<WorkbenchCommand, 5> workbench_commands{{
    {"segment", "Segments a PCD file or a recording, offline"},
    {"verify", "Segments a recording's clouds, and compares with labels and segments on file"},
    {"bench", "Time of the segmentation by stage, and its quality, beside PCL's"},
    {"evaluate", "How good segmentations are on labelled clouds, side by side"},
    {"study", "The thesis's parameter studies anew, drawn with gnuplot"},
}};

// Each hands over all words behind its name, --help as well, to that program. The action does
// not return; it throws std::runtime_error, with what to install, where there is none.
void add_workbench_commands(CLI::App& app, Action& action);

}  // namespace cleave::client
