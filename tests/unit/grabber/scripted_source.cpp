// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/grabber/scripted_source.hpp"

#include <exception>
#include <thread>

namespace cleave::sensor {

Failure ScriptedSource::open() {
  if (failures_to_open > 0) {
    --failures_to_open;
    return "nothing is plugged in";
  }
  ++opened;
  return std::nullopt;
}

Poll ScriptedSource::next(std::chrono::milliseconds timeout, Frame& frame) {
  if (silent) {
    std::this_thread::sleep_for(timeout);
    return Poll::timeout;
  }
  if (next_ == events_.size()) return Poll::end;
  const Event event = events_[next_++];
  if (event == Event::lost) return Poll::lost;
  ++frames_;
  too_large_ = event == Event::frame_too_large;
  const auto width = static_cast<std::uint32_t>(too_large_ ? capacity_points + 1 : 1);
  frame = {width, 1, {}, 1, 0, event == Event::frame_of_new_epoch};
  return Poll::frame;
}

void ScriptedSource::write_points(float* xyz) {
  if (too_large_) std::terminate();
  xyz[0] = frames_;
  xyz[1] = 0;
  xyz[2] = 1;
}

}  // namespace cleave::sensor
