// SPDX-License-Identifier: BSD-3-Clause
// Why there is no shared memory: what keeps this process from RouDi, and what to do about it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace cleave {

// Compiled into iceoryx 2.
struct RouDiPlace {
  std::filesystem::path socket = "/tmp/roudi";
  std::filesystem::path memory = "/dev/shm";
};

// Of RouDi's socket: 0, or what connect() says. Never blocks.
[[nodiscard]] int connection_error(const std::filesystem::path& socket);

// Why this process cannot join RouDi, "what is: what to do" in one line; empty if it can. Looks at
// files and their rights alone, so it neither blocks nor aborts as joining in vain does. Knows: no
// RouDi (or no room for one), a RouDi of another user, a socket or memory without rights.
[[nodiscard]] std::string obstacle_to_roudi(const RouDiPlace& place = {});

// Is one of RouDi's segments, each named after the group that may write to it, of a group of ours?
// Where it is not and nothing is in the way, we may read.
[[nodiscard]] bool may_write_to_roudi(const RouDiPlace& place = {});

// Why RouDi's pools cannot carry samples of `bytes`; empty if they can. Joins RouDi, for as long as
// this process lives: only where nothing is in the way and we may write. A pool that is in use up
// to its last chunk is no obstacle.
[[nodiscard]] std::string obstacle_of_pools(std::uint32_t bytes);

}  // namespace cleave
