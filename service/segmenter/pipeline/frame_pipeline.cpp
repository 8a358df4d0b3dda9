// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/frame_pipeline.hpp"

#include <spdlog/fmt/fmt.h>

#include <exception>
#include <utility>

#include "recording/units/suspected_unit.hpp"
#include "segmentation/result_check.hpp"
#include "segmenter/pipeline/frame_check.hpp"

namespace cleave::service {
namespace {

// Rejected frames need no worker and no place in the queue; so many may wait for earlier frames.
constexpr std::size_t waiting_rejected_frames = 16;

float milliseconds(std::int64_t duration_ns) {
  return static_cast<float>(static_cast<double>(duration_ns) * 1e-6);
}

}  // namespace

FramePipeline::FramePipeline(const PipelineSettings& settings, ResultSink& sink,
                             std::vector<SegmentFunction> segmenters)
    : settings_(settings),
      sink_(sink),
      publisher_(sink, ledger_, latency_, problems_),
      order_(settings.queue_capacity + ResultSink::max_loans + waiting_rejected_frames,
             [this](FinishedFrame& frame) { publisher_.publish(frame); }),
      queue_(settings.mode, settings.queue_capacity, ResultSink::max_loans),
      segmenters_(std::move(segmenters)) {
  for (const SegmentFunction& segment : segmenters_) {
    workers_.emplace_back([this, &segment] { work(segment); });
  }
}

void FramePipeline::accept(ReceivedCloud cloud) {
  const FrameHeader header = private_copy(*cloud.header);
  const std::optional<RejectCause> bad =
      check_header(header, settings_.sensor, cloud.room.size() / 3);
  const Arrived arrived = ledger_.arrive(key_of(header), cloud.zero_copy);
  if (arrived.missed > 0) report_gap(header, arrived.missed);
  if (arrived.arrival == Arrival::in_flight) return;
  if (bad) {
    answer_rejected(header, *bad);
  } else {
    enqueue(header, std::move(cloud));
  }
}

void FramePipeline::answer_rejected(const FrameHeader& header, RejectCause cause) {
  FinishedFrame finished;
  finished.accepted_ns = monotonic_now_ns();
  finished.header = answerable(header, settings_.sensor);
  finished.rejected = cause;
  order_.complete(order_.draw(), std::move(finished));
}

void FramePipeline::enqueue(const FrameHeader& header, ReceivedCloud cloud) {
  const std::optional<Frame> crowded_out =
      queue_.push({order_.draw(), header, std::move(cloud), monotonic_now_ns()});
  if (crowded_out) drop(*crowded_out, DropCause::queue);
}

void FramePipeline::work(const SegmentFunction& segment) {
  while (std::optional<FrameQueue<Frame>::Taken> taken = queue_.take()) {
    process(std::move(*taken), segment);
  }
}

void FramePipeline::process(FrameQueue<Frame>::Taken taken, const SegmentFunction& segment) {
  Frame& frame = taken.frame;
  FinishedFrame finished;
  finished.header = frame.header;
  finished.accepted_ns = frame.accepted_ns;
  finished.place = std::move(taken.place);
  finished.labels = sink_.loan_labels(point_count(frame.header));
  if (!finished.labels) {
    report(frame, "dropped", sink_.no_memory());
    drop(frame, DropCause::no_free_chunk);
    return;
  }
  const std::int64_t started_ns = monotonic_now_ns();
  try {
    finished.rejected = segment_into(finished, frame, segment);
  } catch (const std::exception& error) {
    report(frame, "rejected", error.what());
    finished.rejected = RejectCause::segmentation_failed;
    finished.segmentation = {};
  }
  finished.queue_ms = milliseconds(started_ns - frame.accepted_ns);
  finished.segmentation_ms = milliseconds(monotonic_now_ns() - started_ns);
  frame.cloud = {};
  if (finished.rejected) finished.labels.reset();
  order_.complete(frame.ticket, std::move(finished));
}

// Reads the points, and writes the labels, where the transport has them.
std::optional<RejectCause> FramePipeline::segment_into(FinishedFrame& finished, const Frame& frame,
                                                       const SegmentFunction& segment) {
  const segmentation::CloudView cloud{frame.cloud.room.data(), 3, frame.header.width,
                                      frame.header.height};
  const std::span<std::uint16_t> labels = finished.labels->room().first(cloud.size());
  if (settings_.check_unit && has_wrong_unit(frame, cloud)) return RejectCause::wrong_unit;
  const auto rejected = reject_cause(segment(cloud, labels, finished.segmentation));
  if (!rejected) advise(segmentation::doubt_about(finished.segmentation));
  return rejected;
}

bool FramePipeline::has_wrong_unit(const Frame& frame, const segmentation::CloudView& cloud) {
  const auto suspicion = recording::suspected_unit({cloud.xyz, 3 * cloud.size()});
  if (!suspicion) return false;
  report(frame, "rejected",
         fmt::format("its points seem to be in {}: {}; cleave-grabber --unit mm scales files; if "
                     "they are metres, set check_unit: false in segmenter.yaml",
                     recording::plural_of(suspicion->unit), suspicion->evidence));
  return true;
}

void FramePipeline::advise(segmentation::Doubt doubt) {
  if (doubt == segmentation::Doubt::none) return;
  Advice& advice = advice_.at(static_cast<std::size_t>(doubt));
  if (advice.given.exchange(true)) return;
  problems_.report(
      ProblemLog::Severity::warning, advice.log,
      fmt::format("sensor '{}': {}", settings_.sensor, segmentation::advice_on(doubt)));
}

void FramePipeline::drop(const Frame& frame, DropCause cause) {
  ledger_.drop(key_of(frame.header), cause);
  order_.skip(frame.ticket);
}

void FramePipeline::report(const Frame& frame, std::string_view fate, std::string_view why) {
  problems_.report(ProblemLog::Severity::error, frame_log_,
                   fmt::format("frame {} of sensor '{}' is {}: {}", frame.header.frame_id,
                               settings_.sensor, fate, why));
}

void FramePipeline::report_gap(const FrameHeader& header, std::uint64_t missed) {
  const auto severity = settings_.mode == Mode::lossless ? ProblemLog::Severity::error
                                                         : ProblemLog::Severity::warning;
  problems_.report(severity, gap_log_,
                   fmt::format("{} frames of sensor '{}' before frame {} were lost in transport",
                               missed, settings_.sensor, header.frame_id));
}

void FramePipeline::drain() {
  queue_.close();
  for (std::thread& worker : workers_) worker.join();
  workers_.clear();
}

}  // namespace cleave::service
