// SPDX-License-Identifier: BSD-3-Clause
// A source whose every frame and mishap a test decides.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "sensor/sources/source.hpp"

namespace cleave::sensor {

class ScriptedSource : public Source {
 public:
  enum class Event { frame, frame_of_new_epoch, frame_too_large, lost };

  // Plays the events in order, then ends. The n-th frame has one point, (n, 0, 1); one that
  // is too large has one more than a cloud holds, and may not be asked for them.
  ScriptedSource(std::vector<Event> events, bool realtime)
      : events_(std::move(events)), realtime_(realtime) {}

  [[nodiscard]] Failure open() override;
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return realtime_; }
  [[nodiscard]] SourceCounts counts() const override { return {}; }
  [[nodiscard]] std::string last_error() const override { return "the cable was pulled"; }

  std::atomic<int> failures_to_open = 0;  // the next so many attempts fail
  [[nodiscard]] bool in_use() const override { return taken; }

  std::atomic<int> opened = 0;
  std::atomic<bool> taken = false;  // what in_use() says
  // A camera that has no frame until somebody watches.
  std::atomic<bool> silent = false;

 private:
  std::vector<Event> events_;
  bool realtime_;
  std::size_t next_ = 0;
  bool too_large_ = false;
  float frames_ = 0;
};

}  // namespace cleave::sensor
