// SPDX-License-Identifier: BSD-3-Clause
// `cleave info`: what a recording holds.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_info_command(CLI::App& app, Action& action);

}  // namespace cleave::client
