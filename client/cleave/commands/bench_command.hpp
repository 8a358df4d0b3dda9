// `cleave bench`: what the segmentation costs, stage by stage and beside PCL, and what for.
#pragma once

#include "cleave/commands/command.hpp"

namespace cleave::client {

void add_bench_command(CLI::App& app, Action& action);

}  // namespace cleave::client
