// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/watch/watch_session.hpp"

#include "cleave/stream/contract_frames.hpp"
#include "cleave/stream/list_arrival.hpp"

namespace cleave::client {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono_literals::operator""ms;

// How soon a signal or an end without a last message is noticed.
constexpr auto watch_wait = 100ms;
// Nodes report every half second.
constexpr auto status_patience = 1500ms;

}  // namespace

WatchSession::WatchSession(Stream& stream, const std::string& sensor, bool with_clouds)
    : stream_(stream),
      sensor_(sensor),
      lists_(stream, sensor),
      statuses_(stream, sensor),
      label_maps_(stream, sensor),
      account_(sensor) {
  wait_set_.attach(lists_);
  wait_set_.attach(statuses_);
  wait_set_.attach(label_maps_);
  if (with_clouds) wait_set_.attach(clouds_.emplace(stream, sensor));
}

WatchEnd WatchSession::run(Shutdown& shutdown, std::optional<std::uint64_t> frames,
                           const std::function<void(const std::string&)>& on_frame) {
  EndCondition condition(frames, Clock::now());
  while (!shutdown.requested()) {
    (void)wait_set_.wait(watch_wait);
    take_statuses();
    take_clouds();
    take_label_maps();
    take_lists(condition, on_frame);
    if (const auto end = condition.check(account_, Clock::now())) {
      if (*end == WatchEnd::frames_reached) await_segmenter_status();
      return *end;
    }
  }
  await_segmenter_status();
  return WatchEnd::interrupted;
}

void WatchSession::take_statuses() {
  while (const auto sample = statuses_.take()) {
    const NodeReport report = report_of(**sample);
    const Clock::time_point now = Clock::now();
    account_.add_report(report, now);
    if (report.node != segmenter_node(sensor_)) continue;
    segmenter_cpu_.add(report, now);
    ++segmenter_statuses_;
  }
}

void WatchSession::take_clouds() {
  if (!clouds_) return;
  while (auto cloud = clouds_->take()) {
    if (auto frame = joiner_.add(std::move(*cloud))) last_frame_ = std::move(frame);
  }
}

void WatchSession::take_label_maps() {
  while (auto labels = label_maps_.take()) {
    if (!labels->zero_copy()) ++label_maps_copied_;
    if (!clouds_) continue;
    if (auto frame = joiner_.add(std::move(*labels))) last_frame_ = std::move(frame);
  }
}

void WatchSession::take_lists(EndCondition& condition,
                              const std::function<void(const std::string&)>& on_frame) {
  while (const auto list = lists_.take()) {
    const Clock::time_point now = Clock::now();
    const ListArrival arrival = arrival_of(**list, now);
    summary_.add(arrival);
    account_.add_segment_list(now);
    condition.add_segment_list(now);
    last_segments_ = frame_of(**list);
    on_frame(frame_line(arrival, summary_.recent_rate_hz(), zero_copy(), account_.account(now)));
  }
}

// A status that is newer than the last segment list, so that the account covers that list.
void WatchSession::await_segmenter_status() {
  if (!account_.segmenter()) return;
  WaitSet statuses_only;  // the other topics would wake it all the time
  statuses_only.attach(statuses_);
  const std::uint64_t known = segmenter_statuses_;
  const Clock::time_point end = Clock::now() + status_patience;
  while (segmenter_statuses_ == known && statuses_.live_writers() > 0 && Clock::now() < end) {
    (void)statuses_only.wait(watch_wait);
    take_statuses();
  }
}

bool WatchSession::zero_copy() const {
  return account_.zero_copy() && label_maps_copied_ == 0;
}

WatchSummary WatchSession::summary() const {
  WatchSummary summary;
  summary.sensor = sensor_;
  summary.transport = stream_.transport();
  summary.transport_reason = stream_.transport_reason();
  const auto& segmenter = account_.segmenter();
  if (segmenter && segmenter->transport_in_force == Transport::network) {
    summary.transport = segmenter->transport_in_force;
    summary.transport_reason = "the segmenter: " + segmenter->transport_reason;
  }
  summary.zero_copy = zero_copy();
  summary.account = account_.account(Clock::now());
  summary.fps = summary_.mean_rate_hz();
  summary.latency_ms = summary_.latency_ms();
  summary.segments = summary_.segments();
  summary.segmenter_cpu = segmenter_cpu_.share();
  return summary;
}

std::optional<DepthImage> WatchSession::last_image() const {
  if (!last_frame_) return std::nullopt;
  const CloudSample& cloud = last_frame_->cloud;
  const LabelSample& labels = last_frame_->labels;
  const FrameHeader& header = cloud.header();
  if (cloud.xyz().empty() || labels.labels().empty() || header.width != labels.header().width ||
      header.height != labels.header().height) {
    return std::nullopt;
  }
  return depth_image({.xyz = cloud.xyz().data(), .width = header.width, .height = header.height},
                     labels.labels());
}

}  // namespace cleave::client
