// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/capture_clock.hpp"

#include <algorithm>

namespace cleave::sensor {
namespace {

constexpr std::int64_t leak_divisor = 4000;  // 250 ppm
constexpr std::int64_t max_lead_ns = 1'000'000'000;

}  // namespace

CaptureClock::Stamp CaptureClock::stamp(std::uint64_t device_time_us, std::int64_t arrival_ns) {
  const auto device_ns = static_cast<std::int64_t>(device_time_us) * 1000;
  const std::int64_t difference_ns = arrival_ns - device_ns;
  if (!last_) {
    last_ = State{device_ns, arrival_ns, difference_ns};
    return {0, false};
  }
  const std::int64_t allowed_ns =
      last_->offset_ns + (arrival_ns - last_->arrival_ns) / leak_divisor;
  const bool reset = device_ns < last_->device_ns || difference_ns < allowed_ns - max_lead_ns;
  const std::int64_t offset_ns = reset ? difference_ns : std::min(allowed_ns, difference_ns);
  last_ = State{device_ns, arrival_ns, offset_ns};
  return {difference_ns - offset_ns, reset};
}

}  // namespace cleave::sensor
