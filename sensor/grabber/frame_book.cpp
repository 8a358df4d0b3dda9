// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/frame_book.hpp"

namespace cleave::sensor {
namespace {

constexpr std::chrono::seconds rate_interval(2);

std::uint64_t total(const std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t sum = 0;
  for (const auto& [cause, count] : counts) sum += count;
  return sum;
}

}  // namespace

void FrameBook::published(bool zero_copy, Clock::time_point now) {
  ++published_;
  if (zero_copy) ++zero_copy_;
  recent_.push_back(now);
  while (now - recent_.front() > rate_interval) recent_.pop_front();
}

void FrameBook::fill(NodeReport& report, const SourceCounts& source, Clock::time_point now) {
  report.frames_out = published_;
  report.frames_zero_copy = zero_copy_;
  report.interruptions = interruptions_;
  report.dropped_by_cause = dropped_;
  if (source.sensor_drops > 0) report.dropped_by_cause["sensor"] = source.sensor_drops;
  report.rejected_by_cause = source.unusable;
  report.frames_dropped = total(report.dropped_by_cause);
  report.frames_rejected = total(report.rejected_by_cause);
  report.frames_in = report.frames_out + report.frames_dropped + report.frames_rejected;

  while (!recent_.empty() && now - recent_.front() > rate_interval) recent_.pop_front();
  report.rate_hz = 0;
  if (recent_.size() < 2) return;
  const std::chrono::duration<float> span = recent_.back() - recent_.front();
  report.rate_hz = static_cast<float>(recent_.size() - 1) / span.count();
}

}  // namespace cleave::sensor
