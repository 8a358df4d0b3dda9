// SPDX-License-Identifier: BSD-3-Clause
// `cleave replay`: a recording onto the stream.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_replay_command(CLI::App& app, Action& action);

}  // namespace cleave::client
