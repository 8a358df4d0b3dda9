// SPDX-License-Identifier: BSD-3-Clause
// `cleave recover`: what is left of a damaged recording.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_recover_command(CLI::App& app, Action& action);

}  // namespace cleave::client
