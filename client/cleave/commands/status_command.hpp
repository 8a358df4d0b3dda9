// SPDX-License-Identifier: BSD-3-Clause
// `cleave status`: what the nodes say of themselves.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_status_command(CLI::App& app, Action& action);

}  // namespace cleave::client
