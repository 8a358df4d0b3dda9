// SPDX-License-Identifier: BSD-3-Clause
// Recordings whose clock jumps: how long to wait between two frames.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace cleave::recording {

// The time may be set while a recorder runs, by days and in both directions; a replay plays on.
class GapLimit {
 public:
  static constexpr double default_s = 1;

  // The longest wait, in seconds of the recording; a pause that is shorter is kept.
  explicit GapLimit(double longest_s = default_s);

  struct Gap {
    std::chrono::nanoseconds wait{};  // from 0 to the longest; 0 when time went back
    bool is_jump = false;             // it is not what the recording says
  };
  // From the frame of one log time to that of another one. Any two times will do.
  [[nodiscard]] Gap between(std::int64_t before_ns, std::int64_t after_ns) const;

  // For a log: which jump, and what is done about it.
  [[nodiscard]] std::string text_of_jump(std::int64_t before_ns, std::int64_t after_ns) const;

 private:
  std::chrono::nanoseconds longest_;
};

}  // namespace cleave::recording
