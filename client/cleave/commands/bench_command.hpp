// `cleave bench`: what the segmentation's stages cost.
#pragma once

#include "cleave/commands/command.hpp"

namespace cleave::client {

void add_bench_command(CLI::App& app, Action& action);

}  // namespace cleave::client
