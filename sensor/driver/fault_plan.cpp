// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/driver/fault_plan.hpp"

namespace cleave::driver {

using std::chrono::milliseconds;

bool FaultPlan::first_frame(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (started_) return false;
  started_ = now;
  return true;
}

std::optional<FaultPlan::Clock::time_point> FaultPlan::started() const {
  const std::lock_guard lock(mutex_);
  return started_;
}

std::optional<FaultPlan::Absence> FaultPlan::absence() const {
  const auto start = started();
  if (!start || faults_.unplug_at_ms == 0) return std::nullopt;
  const Clock::time_point from = *start + milliseconds(faults_.unplug_at_ms);
  return Absence{from, from + milliseconds(faults_.replug_after_ms)};
}

bool FaultPlan::unplugged(Clock::time_point now) const {
  return within(now, faults_.unplug_at_ms, milliseconds(faults_.replug_after_ms));
}

bool FaultPlan::in_use(Clock::time_point now) const {
  return now < made_ + milliseconds(faults_.in_use_ms);
}

bool FaultPlan::silent(Clock::time_point now) const {
  return unplugged(now) || within(now, faults_.stall_at_ms, milliseconds(faults_.stall_ms));
}

bool FaultPlan::drops(Clock::time_point now) const {
  return within(now, faults_.drop_at_ms,
                faults_.drop_frames * Clock::duration(std::chrono::seconds(1)) / fps_);
}

std::optional<FaultPlan::Clock::time_point> FaultPlan::clock_reset(Clock::time_point now) const {
  const auto start = started();
  if (!start || faults_.clock_reset_at_ms == 0) return std::nullopt;
  const Clock::time_point reset = *start + milliseconds(faults_.clock_reset_at_ms);
  if (now < reset) return std::nullopt;
  return reset;
}

bool FaultPlan::within(Clock::time_point now, std::uint32_t at_ms, Clock::duration length) const {
  const auto start = started();
  if (!start || at_ms == 0) return false;
  const Clock::time_point from = *start + milliseconds(at_ms);
  return now >= from && now < from + length;
}

}  // namespace cleave::driver
