// SPDX-License-Identifier: BSD-3-Clause
// `cleave record`: the live stream into a file.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_record_command(CLI::App& app, Action& action);

}  // namespace cleave::client
