// `cleave verify`: does the segmentation still give what it gave?.
#pragma once

#include "cleave/commands/command.hpp"

namespace cleave::client {

void add_verify_command(CLI::App& app, Action& action);

}  // namespace cleave::client
