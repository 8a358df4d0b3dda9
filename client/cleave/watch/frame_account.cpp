// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/watch/frame_account.hpp"

#include <algorithm>

namespace cleave::client {
namespace {

using std::chrono_literals::operator""ms;

// The segmenter's name for frames that were lost before it saw them.
constexpr const char* transport_cause = "transport";

// Segment lists may come a little after the status that counts them.
constexpr auto settling_time = 200ms;
constexpr auto quiet_time = 1000ms;

void add(std::map<std::string, std::uint64_t>& to,
         const std::map<std::string, std::uint64_t>& counts) {
  for (const auto& [cause, count] : counts) to[cause] += count;
}

void add_counters(NodeReport& to, const NodeReport& report) {
  to.frames_in += report.frames_in;
  to.frames_out += report.frames_out;
  to.frames_dropped += report.frames_dropped;
  to.frames_rejected += report.frames_rejected;
  to.frames_zero_copy += report.frames_zero_copy;
  add(to.dropped_by_cause, report.dropped_by_cause);
  add(to.rejected_by_cause, report.rejected_by_cause);
}

bool same_counters(const NodeReport& a, const NodeReport& b) {
  return a.process_id == b.process_id && a.frames_in == b.frames_in &&
         a.frames_out == b.frames_out && a.frames_dropped == b.frames_dropped &&
         a.frames_rejected == b.frames_rejected && a.frames_in_flight == b.frames_in_flight;
}

std::uint64_t accounted(const NodeReport& segmenter) {
  return segmenter.frames_out + segmenter.frames_dropped + segmenter.frames_rejected;
}

}  // namespace

bool NodeTotals::add(const NodeReport& report) {
  const bool moved = !latest_ || !same_counters(*latest_, report);
  if (latest_ && latest_->process_id != report.process_id) add_counters(earlier_, *latest_);
  latest_ = report;
  return moved;
}

NodeReport NodeTotals::total() const {
  NodeReport total = latest_.value_or(NodeReport{});
  add_counters(total, earlier_);
  return total;
}

void FrameAccount::add_report(const NodeReport& report, SteadyTime now) {
  if (report.node == grabber_node(sensor_)) {
    if (grabber_.add(report)) last_progress_ = now;
    // An ended grabber says that it is stopping before it leaves; only one that runs again is back.
    if (report.state == NodeState::ended) source_ended_ = true;
    if (report.state == NodeState::running) source_ended_ = false;
  } else if (report.node == segmenter_node(sensor_)) {
    if (segmenter_.add(report)) last_progress_ = now;
    last_segmenter_report_ = now;
  }
}

bool FrameAccount::complete(SteadyTime now) const {
  if (!source_ended_ || now - last_progress_ < settling_time) return false;
  const NodeReport segmenter = segmenter_.total();
  if (segmenter.frames_in_flight > 0) return false;
  if (accounted(segmenter) >= grabber_.total().frames_out) return true;
  // Nothing more will come if the segmenter itself said after the quiet began that nothing moved.
  return now - last_progress_ >= quiet_time && last_segmenter_report_ > last_progress_;
}

Account FrameAccount::account(SteadyTime now) const {
  const NodeReport segmenter = segmenter_.total();
  Account account;
  account.segmented = segmenter.frames_out;
  account.rejected = segmenter.frames_rejected;
  account.dropped = segmenter.frames_dropped;
  account.dropped_by_cause = segmenter.dropped_by_cause;
  account.rejected_by_cause = segmenter.rejected_by_cause;
  account.published = accounted(segmenter);
  const std::uint64_t published = grabber_.total().frames_out;
  if (complete(now) && published > account.published) {
    const std::uint64_t unseen = published - account.published;
    account.dropped += unseen;
    account.dropped_by_cause[transport_cause] += unseen;
    account.published = published;
  }
  return account;
}

bool FrameAccount::zero_copy() const {
  const NodeReport segmenter = segmenter_.total();
  const auto lost = segmenter.dropped_by_cause.find(transport_cause);
  const std::uint64_t unseen = lost == segmenter.dropped_by_cause.end() ? 0 : lost->second;
  const std::uint64_t taken = segmenter.frames_in - std::min(unseen, segmenter.frames_in);
  return taken > 0 && segmenter.frames_zero_copy == taken;
}

}  // namespace cleave::client
