// `cleave segment`: one cloud, offline.
#pragma once

#include "cleave/commands/command.hpp"

namespace cleave::client {

void add_segment_command(CLI::App& app, Action& action);

}  // namespace cleave::client
