// `cleave study`: the thesis's parameter studies anew.
#pragma once

#include "cleave/commands/command.hpp"

namespace cleave::client {

void add_study_command(CLI::App& app, Action& action);

}  // namespace cleave::client
