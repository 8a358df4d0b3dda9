// SPDX-License-Identifier: BSD-3-Clause
// Statuses as the two nodes of the sensor "camera" would publish them.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "libcleave/status.hpp"

namespace cleave::client {

inline NodeReport grabber(NodeState state, std::uint64_t published) {
  NodeReport report;
  report.node = "grabber/camera";
  report.sensor = "camera";
  report.state = state;
  report.frames_in = published;
  report.frames_out = published;
  return report;
}

struct SegmenterCounts {
  std::uint64_t out = 0;
  std::uint64_t dropped = 0;  // in the queue
  std::uint64_t rejected = 0;
  std::uint64_t in_flight = 0;
};

inline NodeReport segmenter(const SegmenterCounts& counts) {
  NodeReport report;
  report.node = "segmenter/camera";
  report.sensor = "camera";
  report.state = NodeState::running;
  report.frames_in = counts.out + counts.dropped + counts.rejected + counts.in_flight;
  report.frames_out = counts.out;
  report.frames_dropped = counts.dropped;
  report.frames_rejected = counts.rejected;
  report.frames_in_flight = counts.in_flight;
  if (counts.dropped > 0) report.dropped_by_cause["queue"] = counts.dropped;
  if (counts.rejected > 0) report.rejected_by_cause["bad size"] = counts.rejected;
  return report;
}

inline std::uint64_t sum_of(const std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t sum = 0;
  for (const auto& [cause, count] : counts) sum += count;
  return sum;
}

}  // namespace cleave::client
