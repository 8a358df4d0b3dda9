// SPDX-License-Identifier: BSD-3-Clause
// `cleave echo`: segment lists as text or JSON.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_echo_command(CLI::App& app, Action& action);

}  // namespace cleave::client
