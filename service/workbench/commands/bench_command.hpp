// SPDX-License-Identifier: BSD-3-Clause
// `cleave bench`: what the segmentation costs, stage by stage and beside PCL, and what for.
#pragma once

#include "console/command.hpp"

namespace cleave::workbench {

void add_bench_command(CLI::App& app, Action& action);

}  // namespace cleave::workbench
