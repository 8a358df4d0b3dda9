// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/frame_ledger.hpp"

#include <algorithm>
#include <numeric>

namespace cleave::service {
namespace {

// Only the lossless grabber resends, and it keeps 4 frames in flight: more than that many drops
// never come back.
constexpr std::size_t remembered_drops = 16;

template <class Cause, std::size_t N>
std::uint64_t& count_of(std::array<std::uint64_t, N>& counts, Cause cause) {
  return counts.at(static_cast<std::size_t>(cause));
}

// Whether a grabber that published `before` counts on to `after`.
bool goes_on(FrameKey before, FrameKey after) {
  const std::uint32_t epochs = after.epoch - before.epoch;
  return epochs <= 1 && after.frame_id > before.frame_id;
}

}  // namespace

std::uint64_t FrameCounts::dropped_total() const {
  return std::accumulate(dropped.begin(), dropped.end(), std::uint64_t{0});
}

std::uint64_t FrameCounts::rejected_total() const {
  return std::accumulate(rejected.begin(), rejected.end(), std::uint64_t{0});
}

Arrived FrameLedger::arrive(FrameKey key, bool zero_copy) {
  const std::lock_guard lock(mutex_);
  if (std::find(flight_.begin(), flight_.end(), key) != flight_.end()) {
    ++counts_.duplicates;
    return {Arrival::in_flight, 0};
  }
  if (!newest_ || key.epoch != newest_->epoch || key.frame_id > newest_->frame_id) {
    const std::uint64_t missed = count_gap(key);
    newest_ = key;
    ++counts_.received;
    if (zero_copy) ++counts_.zero_copy;
    enter_flight(key);
    return {Arrival::fresh, missed};
  }
  if (const std::optional<DropCause> cause = take_back_drop(key)) {
    if (zero_copy && *cause == DropCause::transport) ++counts_.zero_copy;
    enter_flight(key);
    return {Arrival::fresh, 0};
  }
  ++counts_.duplicates;
  return {Arrival::again, 0};
}

void FrameLedger::publish(FrameKey key) {
  const std::lock_guard lock(mutex_);
  if (leave_flight(key)) ++counts_.published;
}

void FrameLedger::drop(FrameKey key, DropCause cause) {
  const std::lock_guard lock(mutex_);
  if (!leave_flight(key)) return;
  ++count_of(counts_.dropped, cause);
  remember_drop(key, cause);
}

void FrameLedger::reject(FrameKey key, RejectCause cause) {
  const std::lock_guard lock(mutex_);
  if (leave_flight(key)) ++count_of(counts_.rejected, cause);
}

FrameCounts FrameLedger::snapshot() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

// The ids between the newest frame and `key`, a later one of the same grabber, never came.
std::uint64_t FrameLedger::count_gap(FrameKey key) {
  if (!newest_ || !goes_on(*newest_, key)) return 0;
  const std::uint64_t missed = key.frame_id - newest_->frame_id - 1;
  counts_.received += missed;
  count_of(counts_.dropped, DropCause::transport) += missed;
  const std::uint64_t remembered = std::min<std::uint64_t>(missed, remembered_drops);
  for (std::uint64_t id = key.frame_id - remembered; id != key.frame_id; ++id) {
    remember_drop({key.epoch, id}, DropCause::transport);
  }
  return missed;
}

std::optional<DropCause> FrameLedger::take_back_drop(FrameKey key) {
  const auto drop = std::find_if(recent_drops_.begin(), recent_drops_.end(),
                                 [&](const Dropped& dropped) { return dropped.key == key; });
  if (drop == recent_drops_.end()) return std::nullopt;
  const DropCause cause = drop->cause;
  --count_of(counts_.dropped, cause);
  recent_drops_.erase(drop);
  return cause;
}

void FrameLedger::enter_flight(FrameKey key) {
  flight_.push_back(key);
  counts_.in_flight = flight_.size();
}

bool FrameLedger::leave_flight(FrameKey key) {
  const auto frame = std::find(flight_.begin(), flight_.end(), key);
  if (frame == flight_.end()) return false;
  flight_.erase(frame);
  counts_.in_flight = flight_.size();
  return true;
}

void FrameLedger::remember_drop(FrameKey key, DropCause cause) {
  if (recent_drops_.size() == remembered_drops) recent_drops_.pop_front();
  recent_drops_.push_back({key, cause});
}

}  // namespace cleave::service
