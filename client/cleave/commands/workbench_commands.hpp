// SPDX-License-Identifier: BSD-3-Clause
// The commands that segment and judge. They are a program of their own, cleave-workbench, so that a
// robot that only looks at its stream needs neither the segmentation nor PCL; people call them as
// `cleave COMMAND` all the same.
#pragma once

#include <array>
#include <string_view>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 has named it
class App;
}

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

// For --help, which lists them.
void add_workbench_commands(CLI::App& app);

[[nodiscard]] bool is_workbench_command(std::string_view word);

// Becomes that program with all of these words, as main() has them, untouched: what an option is,
// and what `--` means, is for that program to say. Does not return; throws std::runtime_error,
// with what to install, where there is none.
[[noreturn]] void run_workbench(char** words);

}  // namespace cleave::client
