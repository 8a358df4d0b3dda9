// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/list_arrival.hpp"

namespace cleave::client {
namespace {

constexpr double ns_per_ms = 1e6;

double milliseconds(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<double>(to_ns - from_ns) / ns_per_ms;
}

// What is neither waiting nor segmenting between reception and publication is publishing: frames
// before this one, and the message itself.
StageTimes stages_of(const SegmentList& list, std::int64_t now_ns) {
  const double in_segmenter =
      milliseconds(list.cloud_reception_time_ns, list.header.publication_time_ns);
  return {milliseconds(list.header.arrival_time_ns, list.cloud_publication_time_ns),
          milliseconds(list.cloud_publication_time_ns, list.cloud_reception_time_ns),
          list.queue_ms,
          list.segmentation_ms,
          in_segmenter - list.queue_ms - list.segmentation_ms,
          milliseconds(list.header.publication_time_ns, now_ns)};
}

}  // namespace

ListArrival arrival_of(const SegmentList& list, std::chrono::steady_clock::time_point now) {
  // steady_clock is CLOCK_MONOTONIC, in which the contract's publication times are.
  const auto now_ns = std::chrono::nanoseconds(now.time_since_epoch()).count();
  ListArrival arrival{};
  arrival.frame_id = list.header.frame_id;
  arrival.epoch = list.header.epoch;
  arrival.latency_ms = milliseconds(list.cloud_publication_time_ns, now_ns);
  arrival.stage_ms = stages_of(list, now_ns);
  if (list.outcome == cleave_v1_OUTCOME_SEGMENTED) arrival.segments = list.segments._length;
  arrival.time = now;
  return arrival;
}

}  // namespace cleave::client
