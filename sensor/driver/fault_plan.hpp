// SPDX-License-Identifier: BSD-3-Clause
// What goes wrong with one synthetic camera, and when.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>

#include "sensor/renderer/scene/scene_uri.hpp"

namespace cleave::driver {

// One for a camera's name, however often the camera is opened: each fault happens once. Safe to use
// from any thread.
class FaultPlan {
 public:
  using Clock = std::chrono::steady_clock;

  FaultPlan(const render::CameraFaults& faults, std::uint32_t fps, Clock::time_point now)
      : faults_(faults), fps_(fps), made_(now) {}

  // The camera is about to send a frame: true for the first one, with which the clock of the plan
  // begins.
  [[nodiscard]] bool first_frame(Clock::time_point now);

  // When the camera is unplugged and plugged in again; only if it is, and after the first frame.
  struct Absence {
    Clock::time_point from;
    Clock::time_point to;
  };
  [[nodiscard]] std::optional<Absence> absence() const;

  [[nodiscard]] bool unplugged(Clock::time_point now) const;
  [[nodiscard]] bool in_use(Clock::time_point now) const;
  // Unplugged, or stalled: no frame comes.
  [[nodiscard]] bool silent(Clock::time_point now) const;
  // The frame of this time is numbered, but lost.
  [[nodiscard]] bool drops(Clock::time_point now) const;
  // When the device's clock was 0, as far as it was reset by `now`.
  [[nodiscard]] std::optional<Clock::time_point> clock_reset(Clock::time_point now) const;

 private:
  // Whether `now` is within `length` from `at_ms`, where that is not 0.
  [[nodiscard]] bool within(Clock::time_point now, std::uint32_t at_ms,
                            Clock::duration length) const;
  [[nodiscard]] std::optional<Clock::time_point> started() const;

  const render::CameraFaults faults_;
  const std::uint32_t fps_;
  const Clock::time_point made_;
  mutable std::mutex mutex_;  // guards started_
  std::optional<Clock::time_point> started_;
};

}  // namespace cleave::driver
