// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/record/record_session.hpp"

#include <spdlog/spdlog.h>

#include "cleave/stream/contract_frames.hpp"
#include "recording/error.hpp"

namespace cleave::client {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr auto recording_wait = 100ms;
// After the source has ended: what is on its way arrives within this time.
constexpr auto last_frames_patience = 2s;
// Frames that may wait while this process sleeps; each holds a chunk of shared memory.
constexpr ReaderDepth reader_depth{8};

}  // namespace

RecordSession::RecordSession(Stream& stream, const std::string& sensor,
                             const std::set<recording::Kind>& topics, BackgroundWriter& writer)
    : sensor_(sensor), writer_(writer), statuses_(stream, sensor) {
  if (topics.contains(recording::Kind::cloud)) {
    wait_set_.attach(clouds_.emplace(stream, sensor, reader_depth));
  }
  if (topics.contains(recording::Kind::labels)) {
    wait_set_.attach(labels_.emplace(stream, sensor, reader_depth));
  }
  if (topics.contains(recording::Kind::segments)) {
    wait_set_.attach(lists_.emplace(stream, sensor, reader_depth));
  }
  wait_set_.attach(statuses_);
}

std::string RecordSession::run(Shutdown& shutdown, std::optional<double> duration_s,
                               const std::function<void()>& on_tick) {
  shutdown.on_request([this] { wait_set_.wake(); });
  std::string reason;
  while (reason.empty()) {
    (void)wait_set_.wait(recording_wait);
    take_clouds();
    take_labels();
    take_lists();
    take_statuses();
    on_tick();
    reason = reason_to_stop(shutdown, duration_s);
  }
  shutdown.on_request([] {});
  return reason;
}

void RecordSession::take_clouds() {
  while (const auto cloud = clouds_ ? clouds_->take() : std::nullopt) {
    note(cloud->header());
    offer(*cloud);
  }
}

void RecordSession::take_labels() {
  while (const auto labels = labels_ ? labels_->take() : std::nullopt) offer(*labels);
}

void RecordSession::take_lists() {
  while (const auto list = lists_ ? lists_->take() : std::nullopt) offer(**list);
}

template <class Message>
void RecordSession::offer(const Message& message) {
  last_frame_ = Clock::now();
  if (!first_frame_) first_frame_ = last_frame_;
  try {
    writer_.offer({wall_now_ns(), client::frame_of(message)});
  } catch (const recording::DataError& error) {
    spdlog::warn("not recorded: {}", error.what());
  }
}

// The ids of the clouds that a sensor publishes have no gaps.
void RecordSession::note(const FrameHeader& header) {
  if (frame_id_ != 0 && header.epoch == epoch_ && header.frame_id > frame_id_ + 1) {
    lost_clouds_ += header.frame_id - frame_id_ - 1;
  }
  epoch_ = header.epoch;
  frame_id_ = header.frame_id;
}

void RecordSession::take_statuses() {
  while (const auto sample = statuses_.take()) {
    const NodeReport report = report_of(**sample);
    if (report.node == grabber_node(sensor_)) source_ended_ = report.state == NodeState::ended;
  }
}

double RecordSession::elapsed_s() const {
  if (!first_frame_) return 0;
  return std::chrono::duration<double>(Clock::now() - *first_frame_).count();
}

std::string RecordSession::reason_to_stop(const Shutdown& shutdown,
                                          std::optional<double> duration_s) const {
  if (shutdown.requested()) return "a signal asked";
  if (const RecordingState state = writer_.state(); !state.stopped.empty()) return state.stopped;
  if (duration_s && elapsed_s() >= *duration_s) return "the time is over";
  if (source_ended_ && first_frame_ && Clock::now() - last_frame_ >= last_frames_patience) {
    return "the source has ended";
  }
  return {};
}

}  // namespace cleave::client
