// SPDX-License-Identifier: BSD-3-Clause
// Is iceoryx's RouDi there, is it still the one that this process joined?
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "libcleave/stream.hpp"

namespace cleave {

// Signs this process off at RouDi, which is `ending`, so that it does not wait for us; the program
// that starts anew in place then does not join it. All readers, writers and the stream must be
// gone.
void leave_roudi(pid_t ending);

// Asks RouDi's socket; never blocks. Creating a shared-memory participant without RouDi blocks for
// a minute and then aborts the process, so ask first.
[[nodiscard]] bool roudi_answers();

// Looks after the RouDi that a node joined, or waits for the one that it would join, once a second,
// and logs what it sees. Of a RouDi that it joined it signs off the dead.
class RouDiWatch {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Task {
    nothing,     // shared memory is switched off: all is always well
    look_after,  // the RouDi that is there now was joined
    wait         // none could be joined
  };
  explicit RouDiWatch(const Stream& stream);
  // With a RouDi elsewhere, for tests.
  RouDiWatch(Task task, std::filesystem::path socket);

  // Call several times a second. True: the error came or went.
  bool update(Clock::time_point now);

  // What a node's status tells while RouDi is gone: what is connected keeps flowing, nobody new can
  // join. Empty while it is there.
  [[nodiscard]] const std::string& error() const { return error_; }

  // Only a process that starts anew joins the RouDi that runs now: another one, from whose
  // processes this one is cut off, or the first.
  [[nodiscard]] bool restart_joins() const { return restart_joins_; }
  // The network carries the clouds: a restart would be an advantage, and no need.
  [[nodiscard]] bool works_without() const { return task_ != Task::look_after; }

 private:
  void wait_for_one();
  void sign_off() const;
  Task task_;
  std::filesystem::path socket_;
  std::uint64_t identity_;  // of the socket's file: of the RouDi that was joined or asked in vain
  Clock::time_point next_look_{};
  std::string error_;
  bool restart_joins_ = false;
};

}  // namespace cleave
