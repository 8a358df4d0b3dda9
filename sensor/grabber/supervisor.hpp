// SPDX-License-Identifier: BSD-3-Clause
// What the grabber tells about itself, and what it sees of RouDi.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "libcleave/roudi.hpp"
#include "libcleave/status.hpp"
#include "libcleave/stream.hpp"

namespace cleave::sensor {

// Publishes the status every half second and at once when the state or the error changes.
class Supervisor {
 public:
  using Clock = std::chrono::steady_clock;
  using Fill = std::function<void(NodeReport&, Clock::time_point)>;  // the counts of the moment

  Supervisor(Stream& stream, const std::string& sensor, Fill fill);

  void set_state(NodeState state);
  [[nodiscard]] NodeState state() const { return report_.state; }
  // The source's; empty = none. Shown unless RouDi is gone, which is worse.
  void set_error(const std::string& error);
  // Both, in one status.
  void set(NodeState state, const std::string& error);
  // Publishes the status if it is due, and checks RouDi if that is. Call several times a second.
  void update(Clock::time_point now);
  // Publishes the status now.
  void publish();
  // Another RouDi than the one that this process joined runs, or the first: only a restart joins
  // it.
  [[nodiscard]] const RouDiWatch& roudi() const { return roudi_; }

 private:
  StatusPublisher publisher_;
  Fill fill_;
  NodeReport report_;
  std::string source_error_;
  RouDiWatch roudi_;
  Clock::time_point next_status_{};
};

}  // namespace cleave::sensor
