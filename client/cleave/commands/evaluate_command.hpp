// `cleave evaluate`: how good segmentations are on labelled clouds.
#pragma once

#include "cleave/commands/command.hpp"

namespace cleave::client {

void add_evaluate_command(CLI::App& app, Action& action);

}  // namespace cleave::client
