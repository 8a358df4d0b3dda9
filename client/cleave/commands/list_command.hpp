// SPDX-License-Identifier: BSD-3-Clause
// `cleave list`: which topics exist, and who writes and reads them.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_list_command(CLI::App& app, Action& action);

}  // namespace cleave::client
