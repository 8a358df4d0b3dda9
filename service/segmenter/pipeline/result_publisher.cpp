// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/result_publisher.hpp"

#include <spdlog/fmt/fmt.h>

#include "segmenter/pipeline/frame_check.hpp"

namespace cleave::service {

void ResultPublisher::publish(FinishedFrame& frame) {
  if (!publish_labels(frame) || !publish_segments(frame)) {
    count_refused(frame);
  } else if (frame.rejected) {
    count_rejected(frame);
  } else {
    ledger_.publish(key_of(frame.header));
    latency_.add(frame.header.publication_time_ns, buffer_.list().header.publication_time_ns);
  }
}

bool ResultPublisher::publish_labels(FinishedFrame& frame) {
  if (!frame.labels) return true;
  frame.labels->header() = frame.header;
  frame.labels->cloud_publication_time_ns() = frame.header.publication_time_ns;
  frame.labels->header().publication_time_ns = monotonic_now_ns();
  return frame.labels->publish();
}

bool ResultPublisher::publish_segments(const FinishedFrame& frame) {
  buffer_.fill(frame.segmentation);
  SegmentList& list = buffer_.list();
  list.header = frame.header;
  list.cloud_publication_time_ns = frame.header.publication_time_ns;
  list.cloud_reception_time_ns = frame.accepted_ns;
  list.outcome = wire_outcome(frame.rejected);
  list.queue_ms = frame.queue_ms;
  list.segmentation_ms = frame.segmentation_ms;
  list.header.publication_time_ns = monotonic_now_ns();
  return sink_.publish(list);
}

void ResultPublisher::count_refused(const FinishedFrame& frame) {
  ledger_.drop(key_of(frame.header), DropCause::refused_by_dds);
  problems_.report(ProblemLog::Severity::error, refused_,
                   fmt::format("frame {} of sensor '{}' is dropped: DDS refused its results",
                               frame.header.frame_id, name_of(frame.header.sensor)));
}

void ResultPublisher::count_rejected(const FinishedFrame& frame) {
  ledger_.reject(key_of(frame.header), *frame.rejected);
  if (*frame.rejected == RejectCause::segmentation_failed ||
      *frame.rejected == RejectCause::wrong_unit) {
    return;  // the worker has said why
  }
  problems_.report(
      ProblemLog::Severity::warning, rejected_,
      fmt::format("frame {} for sensor '{}' is rejected: {} ({} x {} points)",
                  frame.header.frame_id, name_of(frame.header.sensor), to_string(*frame.rejected),
                  frame.header.width, frame.header.height));
}

}  // namespace cleave::service
