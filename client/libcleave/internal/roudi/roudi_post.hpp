// SPDX-License-Identifier: BSD-3-Clause
// What is said to RouDi beside iceoryx's own runtime, which waits for an answer as long as it
// takes.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "libcleave/internal/roudi/roudi_access.hpp"

namespace cleave {

// Joins RouDi for as long as this process lives, under a name that no other process ever had. Only
// where nothing is in the way and RouDi responds: else it blocks for a minute and ends the process.
void join_roudi();
// Whether this process has, if only to ask for its pools.
[[nodiscard]] bool has_joined_roudi();

// Whether RouDi answers within `patience`, not only has its socket: it may be suspended, or the
// socket another program's.
[[nodiscard]] bool roudi_responds(std::chrono::milliseconds patience, const RouDiPlace& place = {});

// What obstacle_to_roudi() says, and besides: RouDi is ending, or does not respond. Blocks for
// `patience` at most.
[[nodiscard]] std::string obstacle_to_joining(std::chrono::milliseconds patience,
                                              const RouDiPlace& place = {});

// Whether RouDi drops whoever does not give a sign of life for 1.5 s (it was started without
// `-m off`). False where that cannot be seen.
[[nodiscard]] bool roudi_drops_suspended();

// Signs off at RouDi those whose process has ended without doing so, so that what they held of
// shared memory is free again, and removes the socket that they left in `place`. A RouDi that
// drops nobody relies on it. Returns their names. Never blocks.
std::vector<std::string> sign_off_the_dead(const RouDiPlace& place = {});

}  // namespace cleave
