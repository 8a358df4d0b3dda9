// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/source_link.hpp"

#include <spdlog/spdlog.h>

namespace cleave::sensor {

bool SourceLink::start() {
  const Failure failure = source_.open();
  if (!failure) {
    supervisor_.set_state(NodeState::running);
    return true;
  }
  if (source_.in_use()) {
    lose(*failure);
    return true;
  }
  spdlog::error("{}", *failure);
  supervisor_.set_error(*failure);
  return false;
}

void SourceLink::reopen(Clock::time_point now) {
  if (!backoff_.due(now)) return;
  if (const Failure failure = source_.open()) {
    backoff_.failed(Clock::now());
    supervisor_.set_error(*failure);
    if (std::uint64_t suppressed = 0; log_limiter_.allow(suppressed)) {
      spdlog::warn("{} ({} more attempts before)", *failure, suppressed);
    }
    return;
  }
  down_ = false;
}

Poll SourceLink::next(std::chrono::milliseconds timeout, Frame& frame) {
  const Poll poll = source_.next(timeout, frame);
  if (poll == Poll::lost) lose(source_.last_error());
  if (poll == Poll::frame) {
    if (frame.begins_epoch && source_.realtime()) {
      spdlog::warn("the camera's clock was reset: a new epoch begins");
      book_.interrupted();
    }
    if (lost_) came_back(frame);
  }
  return poll;
}

void SourceLink::lose(const std::string& error) {
  spdlog::warn("waiting for the source: {}", error);
  down_ = true;
  // One that opens and sends nothing is not opened ever faster.
  if (lost_) {
    backoff_.failed(Clock::now());
  } else {
    backoff_.start(Clock::now());
    book_.interrupted();
  }
  lost_ = true;
  supervisor_.set(NodeState::source_lost, error);
}

void SourceLink::came_back(Frame& frame) {
  spdlog::info("the source is back");
  lost_ = false;
  frame.begins_epoch = true;
  supervisor_.set(NodeState::running, "");
}

}  // namespace cleave::sensor
