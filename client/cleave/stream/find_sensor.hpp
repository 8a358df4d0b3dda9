// SPDX-License-Identifier: BSD-3-Clause
// Which sensor is meant when nobody says so.
#pragma once

#include <chrono>
#include <set>
#include <string>

#include "libcleave/process/shutdown.hpp"
#include "libcleave/stream.hpp"

namespace cleave::client {

// The only sensor of a set that is not empty. Throws std::runtime_error, with advice, when there is
// a choice.
[[nodiscard]] std::string only_sensor(const std::set<std::string>& sensors);

// `wanted` if it is not empty; else the only sensor whose nodes publish a status, for which it
// waits up to `patience`. Throws as only_sensor does, and with nobody_answers() where none does.
[[nodiscard]] std::string find_sensor(Stream& stream, Shutdown& shutdown, const std::string& wanted,
                                      std::chrono::milliseconds patience);

}  // namespace cleave::client
