// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/sensor_pipeline.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <memory>
#include <utility>

namespace cleave::service {
namespace {

// Shared memory has no back pressure: in lossless mode the reader holds the whole window of frames
// that the grabber keeps in flight.
constexpr ReaderDepth lossless_depth{8};

ReaderDepth reader_depth(const PipelineSettings& settings) {
  if (settings.mode == Mode::lossless) return lossless_depth;
  return {topic_of<DepthCloud>(settings.sensor).history_depth};
}

ReceivedCloud received(CloudSample sample) {
  const auto owner = std::make_shared<const CloudSample>(std::move(sample));
  return {owner, &owner->header(), owner->room(), owner->zero_copy()};
}

template <std::size_t N>
std::map<std::string, std::uint64_t> by_name(const std::array<std::uint64_t, N>& counts,
                                             const std::array<const char*, N>& names) {
  std::map<std::string, std::uint64_t> named;
  for (std::size_t i = 0; i < N; ++i) {
    if (counts.at(i) > 0) named[names.at(i)] = counts.at(i);
  }
  return named;
}

}  // namespace

SensorPipeline::SensorPipeline(Stream& stream, const PipelineSettings& settings,
                               std::vector<SegmentFunction> segmenters)
    : stream_(stream),
      sensor_(settings.sensor),
      sink_(stream, settings.sensor),
      clouds_(stream, settings.sensor, reader_depth(settings)),
      pipeline_(settings, sink_, std::move(segmenters)) {
  wait_set_.attach(clouds_);
  taking_ = std::thread([this] { take_clouds(); });
}

void SensorPipeline::take_clouds() {
  while (!stopping_) {
    wait_set_.wait(std::chrono::milliseconds(500));
    while (!stopping_) {
      std::optional<CloudSample> cloud = clouds_.take();
      if (!cloud) break;
      pipeline_.accept(received(std::move(*cloud)));
    }
  }
}

void SensorPipeline::stop_taking() {
  stopping_ = true;
  wait_set_.wake();
  if (taking_.joinable()) taking_.join();
}

bool SensorPipeline::update_state() {
  if (!source_.update(clouds_.live_writers())) return false;
  if (source_.state() == NodeState::running) {
    spdlog::info("sensor '{}': a grabber is there", sensor_);
  } else {
    spdlog::warn("sensor '{}': the source is lost, no grabber is alive; waiting for one", sensor_);
  }
  return true;
}

NodeReport SensorPipeline::report() const {
  const FrameCounts counts = pipeline_.counts();
  const LatencySummary latency = pipeline_.latency().latency();
  NodeReport report = first_report(stream_, segmenter_node(sensor_), sensor_);
  report.state = stopping_ ? NodeState::stopping : source_.state();
  report.frames_in = counts.received;
  report.frames_out = counts.published;
  report.frames_dropped = counts.dropped_total();
  report.frames_rejected = counts.rejected_total();
  report.frames_in_flight = counts.in_flight;
  report.frames_zero_copy = counts.zero_copy;
  report.dropped_by_cause = by_name(counts.dropped, drop_cause_names);
  report.rejected_by_cause = by_name(counts.rejected, reject_cause_names);
  report.rate_hz = pipeline_.latency().rate_hz(monotonic_now_ns());
  report.latency_median_ms = latency.median_ms;
  report.latency_p90_ms = latency.p90_ms;
  report.latency_p99_ms = latency.p99_ms;
  report.cpu_time_s = cpu_time_s();
  report.last_error = pipeline_.last_problem();
  return report;
}

}  // namespace cleave::service
