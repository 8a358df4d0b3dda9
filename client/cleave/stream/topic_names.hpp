// SPDX-License-Identifier: BSD-3-Clause
// The topics of a sensor that recordings hold, as people name them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "recording/frames/frame.hpp"

namespace cleave::client {

// "cloud", "labels" or "segments": the last part of the topic's name.
[[nodiscard]] const char* topic_of(recording::Kind kind);

// Of such names. Throws UsageError, with the names that there are, for any other.
// Empty: all.
[[nodiscard]] std::set<recording::Kind> kinds_of(const std::vector<std::string>& names);

}  // namespace cleave::client
