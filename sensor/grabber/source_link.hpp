// SPDX-License-Identifier: BSD-3-Clause
// A source that comes and goes: lost, opened again, and told of.
#pragma once

#include <chrono>
#include <string>

#include "libcleave/process/logging.hpp"
#include "sensor/grabber/backoff.hpp"
#include "sensor/grabber/frame_book.hpp"
#include "sensor/grabber/supervisor.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// Opens a lost source again after 0.1 s at first and 2 s at last, for as long as it takes. It is
// back, in state and error of the status, with its first frame: a camera that opens and stays
// silent is not. A source that somebody else has at the start is waited for in the same way.
class SourceLink {
 public:
  using Clock = std::chrono::steady_clock;

  // All must outlive the link. The book counts how often a source was lost or, with a device, its
  // clock was reset.
  SourceLink(Source& source, Supervisor& supervisor, FrameBook& book)
      : source_(source), supervisor_(supervisor), book_(book) {}

  // Opens the source for the first time. False: it cannot be opened, and waiting will not help.
  [[nodiscard]] bool start();
  // Lost, and not opened again: reopen() is to be called.
  [[nodiscard]] bool is_down() const { return down_; }
  // Opens the source again if that is due.
  void reopen(Clock::time_point now);
  // The source's next frame; one that is the first since the source was lost begins an epoch.
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame);

 private:
  void lose(const std::string& error);
  void came_back(Frame& frame);

  Source& source_;
  Supervisor& supervisor_;
  FrameBook& book_;
  Backoff backoff_;
  LogLimiter log_limiter_;
  bool down_ = false;
  bool lost_ = false;  // no frame has come since it was lost
};

}  // namespace cleave::sensor
