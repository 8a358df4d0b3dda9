// SPDX-License-Identifier: BSD-3-Clause
// When was a frame captured, by the clock on the wall? Devices stamp frames by clocks of their own
// that drift; their frames arrive late by a varying time.
#pragma once

#include <cstdint>
#include <optional>

namespace cleave::sensor {

// The offset between the two clocks is the smallest difference of arrival and device time seen, for
// the least delayed frame tells it best. It is let grow by 250 ppm of the time that passes, so that
// a device clock that is slower than the host's is followed (measured drifts are about 75 ppm).
class CaptureClock {
 public:
  struct Stamp {
    std::int64_t delay_ns;  // from capture to arrival, but for the least delay of all; >= 0
    bool reset;             // the device's clock jumped: the filter has begun anew
  };

  // Of a frame with this device time that arrived at this time of CLOCK_MONOTONIC. A device time
  // before the last one, or one more than a second ahead of what the offset allows, is a reset.
  [[nodiscard]] Stamp stamp(std::uint64_t device_time_us, std::int64_t arrival_ns);

  void restart() { last_.reset(); }

 private:
  struct State {
    std::int64_t device_ns;
    std::int64_t arrival_ns;
    std::int64_t offset_ns;
  };
  std::optional<State> last_;
};

}  // namespace cleave::sensor
