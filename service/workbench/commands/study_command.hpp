// SPDX-License-Identifier: BSD-3-Clause
// `cleave study`: the thesis's parameter studies anew.
#pragma once

#include "console/command.hpp"

namespace cleave::workbench {

void add_study_command(CLI::App& app, Action& action);

}  // namespace cleave::workbench
