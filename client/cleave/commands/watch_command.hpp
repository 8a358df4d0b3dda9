// SPDX-License-Identifier: BSD-3-Clause
// `cleave watch`: every frame of a sensor until the stream ends, and a summary.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_watch_command(CLI::App& app, Action& action);

}  // namespace cleave::client
