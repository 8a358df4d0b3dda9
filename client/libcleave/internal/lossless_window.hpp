// SPDX-License-Identifier: BSD-3-Clause
// Which frames are on their way in lossless mode. Shared memory has no back pressure, so the
// grabber keeps a window of frames in flight and publishes the next one when segment lists come
// back.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "idl/frame_key.hpp"

namespace cleave {

// - Slow start: until a first segment list has come back one frame is in flight, for a reader that
//   has just been matched may miss what is published at once.
// - Go-back-N: after 2 s without any list coming back (4 s, 8 s and 16 s when that repeats: the
//   segmenter may be that slow), or when a segmenter is matched after there was none, all frames
//   in flight are published again, in order, by slow start.
// Frames are acknowledged one by one, in any order, by epoch and frame id.
//
// Times are arguments, so that the logic has no clock; they must not decrease.
class LosslessWindow {
 public:
  using Clock = std::chrono::steady_clock;

  explicit LosslessWindow(std::uint32_t size) : size_(size) {}

  // Call often. `segmenters`: how many are matched.
  void update(Clock::time_point now, unsigned segmenters);
  // The frame that must be published again now, the oldest first; none if nothing is due.
  [[nodiscard]] std::optional<FrameKey> to_resend() const;
  // Whether a new frame may be published now.
  [[nodiscard]] bool has_room() const;
  // A frame was published, new or again.
  void published(FrameKey frame, Clock::time_point now);
  // Its segment list came back; a list of no frame in flight changes nothing.
  void returned(FrameKey frame, Clock::time_point now);
  // Published and not come back.
  [[nodiscard]] std::size_t in_flight() const { return frames_.size(); }
  [[nodiscard]] bool contains(FrameKey frame) const;

 private:
  struct Entry {
    FrameKey frame;
    bool sent;  // false: to be published again
  };
  void go_back(Clock::time_point now);
  [[nodiscard]] std::size_t limit() const { return opened_ ? size_ : 1; }
  [[nodiscard]] std::size_t sent() const;

  std::uint32_t size_;
  std::deque<Entry> frames_;  // oldest first
  bool opened_ = false;       // a list has come back since the start or the last resend
  unsigned segmenters_ = 0;
  std::chrono::seconds patience_ = first_patience;
  Clock::time_point last_progress_{};

  static constexpr std::chrono::seconds first_patience{2};
  static constexpr std::chrono::seconds last_patience{16};
};

}  // namespace cleave
