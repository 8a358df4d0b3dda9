// SPDX-License-Identifier: BSD-3-Clause
// `cleave hz`: rate and latency of the segment lists.
#pragma once

#include "console/command.hpp"

namespace cleave::client {

void add_hz_command(CLI::App& app, Action& action);

}  // namespace cleave::client
