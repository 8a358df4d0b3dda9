// SPDX-License-Identifier: BSD-3-Clause
// The lossless mode at work: segment lists come in, frames are kept until theirs has.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "libcleave/cloud_writer.hpp"
#include "libcleave/internal/lossless_window.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// A published frame, kept because it may have to be published again.
struct KeptFrame {
  FrameHeader header;
  std::vector<float> xyz;
};

class LosslessFlow {
 public:
  using Clock = LosslessWindow::Clock;

  LosslessFlow(Stream& stream, const std::string& sensor, std::uint32_t window);

  // Takes the segment lists that have come in, and publishes again what is due.
  void update(Clock::time_point now, CloudWriter& writer);
  // A new frame may be published: there is room, and a segmenter to tell when it is done.
  [[nodiscard]] bool ready() const { return segmenters() > 0 && window_.has_room(); }
  [[nodiscard]] unsigned segmenters() const { return segments_.live_writers(); }
  void published(KeptFrame frame, Clock::time_point now);
  [[nodiscard]] std::size_t in_flight() const { return window_.in_flight(); }
  // For a wait set.
  [[nodiscard]] const Reader<SegmentList>& segments() const { return segments_; }

 private:
  Reader<SegmentList> segments_;
  LosslessWindow window_;
  std::deque<KeptFrame> kept_;  // the frames of the window
};

}  // namespace cleave
