// SPDX-License-Identifier: BSD-3-Clause
// `cleave evaluate`: how good segmentations are on labelled clouds.
#pragma once

#include "console/command.hpp"

namespace cleave::workbench {

void add_evaluate_command(CLI::App& app, Action& action);

}  // namespace cleave::workbench
