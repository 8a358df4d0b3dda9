// SPDX-License-Identifier: BSD-3-Clause
// `cleave convert`: recordings from one format to another.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_convert_command(CLI::App& app, Action& action);

}  // namespace cleave::client
