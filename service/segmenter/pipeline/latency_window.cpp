// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/latency_window.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::service {

void LatencyWindow::Ring::add(std::int64_t value_ns) {
  values_ns.at(next) = value_ns;
  next = (next + 1) % capacity;
  size = std::min(size + 1, capacity);
}

void LatencyWindow::add(std::int64_t from_ns, std::int64_t to_ns) {
  const std::lock_guard lock(mutex_);
  done_.add(to_ns);
  if (from_ns >= 0 && from_ns <= to_ns) latencies_.add(to_ns - from_ns);
}

LatencySummary LatencyWindow::latency() const {
  Ring sorted;
  {
    const std::lock_guard lock(mutex_);
    sorted = latencies_;
  }
  if (sorted.size == 0) return {};
  const auto begin = sorted.values_ns.begin();
  std::sort(begin, begin + static_cast<std::ptrdiff_t>(sorted.size));
  const auto nearest_rank_ms = [&](std::size_t percent) {
    const std::size_t rank = (sorted.size * percent + 99) / 100;  // rounded up, from 1
    return static_cast<float>(static_cast<double>(sorted.values_ns.at(rank - 1)) * 1e-6);
  };
  return {nearest_rank_ms(50), nearest_rank_ms(90), nearest_rank_ms(99)};
}

float LatencyWindow::rate_hz(std::int64_t now_ns) const {
  const std::lock_guard lock(mutex_);
  const auto begin = done_.values_ns.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(done_.size);
  const auto recent = std::count_if(
      begin, end, [&](std::int64_t done_ns) { return now_ns - done_ns < rate_span_ns; });
  // Above 150 frames a second the ring holds less than the span.
  const bool full = static_cast<std::size_t>(recent) == capacity;
  const std::int64_t span_ns =
      full ? std::max<std::int64_t>(now_ns - done_.values_ns.at(done_.next), 1) : rate_span_ns;
  return static_cast<float>(static_cast<double>(recent) * 1e9 / static_cast<double>(span_ns));
}

}  // namespace cleave::service
