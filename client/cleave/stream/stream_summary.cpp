// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/stream_summary.hpp"

#include <numeric>

namespace cleave::client {
namespace {

constexpr std::size_t recent_lists = 30;

double rate_hz(std::uint64_t intervals, std::chrono::steady_clock::duration elapsed) {
  const double seconds = std::chrono::duration<double>(elapsed).count();
  return seconds > 0 ? static_cast<double>(intervals) / seconds : 0;
}

}  // namespace

void StreamSummary::add(const ListArrival& arrival) {
  if (last_ && last_->epoch == arrival.epoch && arrival.frame_id > last_->frame_id) {
    gaps_ += arrival.frame_id - last_->frame_id - 1;
  }
  ++lists_;
  if (!first_) first_ = arrival;
  last_ = arrival;
  recent_.push_back(arrival.time);
  if (recent_.size() > recent_lists) recent_.pop_front();
  if (!arrival.segments) return;
  latency_ms_.add(arrival.latency_ms);
  for (std::size_t stage = 0; stage < latency_stages.size(); ++stage) {
    stage_ms_.at(stage).add(arrival.stage_ms.at(stage));
  }
  total_ms_.add(std::accumulate(arrival.stage_ms.begin(), arrival.stage_ms.end(), 0.0));
  segments_.add(static_cast<double>(*arrival.segments));
}

double StreamSummary::mean_rate_hz() const {
  return lists_ < 2 ? 0 : rate_hz(lists_ - 1, last_->time - first_->time);
}

double StreamSummary::recent_rate_hz() const {
  return lists_ < 2 ? 0 : rate_hz(recent_.size() - 1, recent_.back() - recent_.front());
}

}  // namespace cleave::client
