#include "cleave/stream/list_arrival.hpp"

namespace cleave::client {

ListArrival arrival_of(const SegmentList& list, std::chrono::steady_clock::time_point now) {
  constexpr double ns_per_ms = 1e6;
  // steady_clock is CLOCK_MONOTONIC, in which the contract's publication times are.
  const auto now_ns = std::chrono::nanoseconds(now.time_since_epoch()).count();
  ListArrival arrival{};
  arrival.frame_id = list.header.frame_id;
  arrival.epoch = list.header.epoch;
  arrival.latency_ms = static_cast<double>(now_ns - list.cloud_publication_time_ns) / ns_per_ms;
  if (list.outcome == cleave_v1_OUTCOME_SEGMENTED) arrival.segments = list.segments._length;
  arrival.time = now;
  return arrival;
}

}  // namespace cleave::client
