// SPDX-License-Identifier: BSD-3-Clause
// What became of every frame of the source, and what the next one is called.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "idl/frame_key.hpp"
#include "libcleave/status.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// Always: frames in = frames out + dropped + rejected, where `in` counts all that the source had,
// also frames that the sensor lost and files that could not be used.
class FrameBook {
 public:
  using Clock = std::chrono::steady_clock;

  // Epochs begin at the Unix time in seconds, so that they rise from one start to the next.
  explicit FrameBook(std::uint32_t first_epoch) : epoch_(first_epoch) {}

  // The source reconnected, began again, or reset its clock.
  void begin_epoch() { ++epoch_; }
  // It was lost, or its clock was reset.
  void interrupted() { ++interruptions_; }
  // Of the next frame that is published. Ids begin at 1 and go on across epochs.
  [[nodiscard]] FrameKey next() const { return {epoch_, published_ + 1}; }

  void published(bool zero_copy, Clock::time_point now);
  void dropped(const std::string& cause) { ++dropped_[cause]; }
  [[nodiscard]] std::uint64_t published_count() const { return published_; }

  // Fills in the counts and the rate, the mean over the last 2 s.
  void fill(NodeReport& report, const SourceCounts& source, Clock::time_point now);

 private:
  std::uint32_t epoch_;
  std::uint64_t published_ = 0;
  std::uint64_t zero_copy_ = 0;
  std::uint64_t interruptions_ = 0;
  std::map<std::string, std::uint64_t> dropped_;
  std::deque<Clock::time_point> recent_;  // publications of the last 2 s
};

}  // namespace cleave::sensor
