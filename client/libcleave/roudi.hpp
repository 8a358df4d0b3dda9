// SPDX-License-Identifier: BSD-3-Clause
// Is iceoryx's RouDi there, is it still the one that this process joined?
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "libcleave/stream.hpp"

namespace cleave {

// Asks RouDi's socket; never blocks. Creating a shared-memory participant without RouDi blocks for
// a minute and then aborts the process, so ask first.
[[nodiscard]] bool roudi_answers();

// Looks after the RouDi that a node joined, once a second, and logs what it sees.
class RouDiWatch {
 public:
  using Clock = std::chrono::steady_clock;

  // Remembers the RouDi that is there now. Where the network carries the clouds none was joined:
  // then all is always well.
  explicit RouDiWatch(Transport in_force);
  // With a RouDi elsewhere, for tests.
  RouDiWatch(Transport in_force, std::filesystem::path socket);

  // Call several times a second. True: the error came or went.
  bool update(Clock::time_point now);

  // What a node's status tells while RouDi is gone: what is connected keeps flowing, nobody new can
  // join. Empty while it is there.
  [[nodiscard]] const std::string& error() const { return error_; }

  // Another RouDi runs: this process is cut off from all that joined it, and must restart.
  [[nodiscard]] bool replaced() const { return replaced_; }

 private:
  std::filesystem::path socket_;  // empty: nothing to look after
  std::uint64_t identity_;        // of the socket's file
  Clock::time_point next_look_{};
  std::string error_;
  bool replaced_ = false;
};

}  // namespace cleave
