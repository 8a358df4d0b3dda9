// SPDX-License-Identifier: BSD-3-Clause
// `cleave verify`: does the segmentation still give what it gave?.
#pragma once

#include "console/command.hpp"

namespace cleave::workbench {

void add_verify_command(CLI::App& app, Action& action);

}  // namespace cleave::workbench
