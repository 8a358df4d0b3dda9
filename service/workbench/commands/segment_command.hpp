// SPDX-License-Identifier: BSD-3-Clause
// `cleave segment`: one cloud, offline.
#pragma once

#include "console/command.hpp"

namespace cleave::workbench {

void add_segment_command(CLI::App& app, Action& action);

}  // namespace cleave::workbench
