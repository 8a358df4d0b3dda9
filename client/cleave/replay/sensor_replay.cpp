// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/replay/sensor_replay.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cleave/stream/contract_frames.hpp"

namespace cleave::client {
namespace {

constexpr std::chrono::milliseconds status_interval{500};
// Label maps and segment lists follow their clouds by fewer frames than that.
constexpr std::size_t remembered_clouds = 64;
// Kept for readers that the network serves, which may come in bursts.
constexpr WriterDepth writer_depth{8};

// There is no memory for a frame: readers hold all of it, or there will never be any.
bool not_now(const std::string& obstacle) {
  if (!obstacle.empty()) throw std::runtime_error(obstacle);
  return false;
}

}  // namespace

SensorReplay::SensorReplay(Stream& stream, const std::string& sensor,
                           const std::set<recording::Kind>& kinds,
                           std::optional<std::uint32_t> window)
    : statuses_(stream) {
  const bool has_clouds = kinds.contains(recording::Kind::cloud);
  if (has_clouds) {
    lock_.emplace(stream.options().domain, sensor);
    clouds_.emplace(stream, sensor, writer_depth);
  }
  if (kinds.contains(recording::Kind::labels)) labels_.emplace(stream, sensor, writer_depth);
  if (kinds.contains(recording::Kind::segments)) lists_.emplace(stream, sensor, writer_depth);
  if (window) flow_.emplace(stream, sensor, *window);
  report_ = first_report(stream, has_clouds ? grabber_node(sensor) : "replay/" + sensor, sensor);
  report_.state = NodeState::running;
}

void SensorReplay::update() {
  const auto now = Clock::now();
  if (flow_) flow_->update(now, *clouds_);
  if (now >= next_status_) publish_status();
}

void SensorReplay::set_state(NodeState state) {
  report_.state = state;
  publish_status();
}

void SensorReplay::publish_status() {
  next_status_ = Clock::now() + status_interval;
  report_.frames_in = report_.frames_out;
  report_.frames_in_flight = in_flight();
  statuses_.publish(report_);
}

bool SensorReplay::has_readers() const {
  if (flow_) return clouds_->matched_readers() > 0 && flow_->segmenters() > 0;
  return (clouds_ && clouds_->matched_readers() > 0) ||
         (labels_ && labels_->matched_readers() > 0) || (lists_ && lists_->matched_readers() > 0);
}

bool SensorReplay::ready() const {
  return has_readers() && (!flow_ || flow_->ready());
}

bool SensorReplay::publish(const recording::Frame& frame, std::uint64_t pass) {
  if (std::exchange(pass_, pass) != pass) {
    epoch_shift_ = last_epoch_ + 1 - frame.header().epoch;  // modulo 2^32, as epochs are
  }
  const bool published = std::visit([this](const auto& f) { return publish(f); }, frame.content);
  if (published) last_epoch_ = frame.header().epoch + epoch_shift_;
  return published;
}

bool SensorReplay::publish(const recording::Cloud& cloud) {
  std::optional<CloudLoan> loan = clouds_->loan(cloud.header.points());
  if (!loan) return not_now(clouds_->obstacle());
  fill(*loan, cloud);
  FrameHeader& header = loan->header();
  set_epoch(header);
  const std::int64_t time_ns = monotonic_now_ns();
  header.arrival_time_ns = time_ns;
  header.publication_time_ns = time_ns;
  KeptFrame copy;
  if (flow_) copy = {header, cloud.xyz};
  const Published entry{key_of(header), time_ns};
  const bool zero_copy = clouds_->zero_copy();
  if (!std::move(*loan).publish()) return false;
  if (flow_) flow_->published(std::move(copy), Clock::now());
  published_.push_back(entry);
  if (published_.size() > remembered_clouds) published_.pop_front();
  ++report_.frames_out;
  if (zero_copy) ++report_.frames_zero_copy;
  return true;
}

bool SensorReplay::publish(const recording::Labels& labels) {
  std::optional<LabelLoan> loan = labels_->loan(labels.header.points());
  if (!loan) return not_now(labels_->obstacle());
  fill(*loan, labels);
  FrameHeader& header = loan->header();
  set_epoch(header);
  header.arrival_time_ns = cloud_time_ns(labels.header);
  loan->cloud_publication_time_ns() = header.arrival_time_ns;
  header.publication_time_ns = monotonic_now_ns();
  return std::move(*loan).publish();
}

bool SensorReplay::publish(const recording::SegmentList& list) {
  SegmentListMessage buffer(list);
  SegmentList& message = buffer.message();
  set_epoch(message.header);
  message.header.arrival_time_ns = cloud_time_ns(list.header);
  message.cloud_publication_time_ns = message.header.arrival_time_ns;
  message.cloud_reception_time_ns = message.header.arrival_time_ns;
  message.header.publication_time_ns = monotonic_now_ns();
  return lists_->publish(message);
}

// When its cloud was replayed; now, if it was not.
std::int64_t SensorReplay::cloud_time_ns(const recording::FrameHeader& header) const {
  const FrameKey frame{header.epoch + epoch_shift_, header.frame_id};
  const auto found = std::ranges::find(published_, frame, &Published::frame);
  return found == published_.end() ? monotonic_now_ns() : found->time_ns;
}

}  // namespace cleave::client
