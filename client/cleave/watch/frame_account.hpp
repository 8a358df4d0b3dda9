// SPDX-License-Identifier: BSD-3-Clause
// What became of every frame that a sensor's grabber published, from the statuses of the two nodes.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "libcleave/status.hpp"

namespace cleave::client {

using SteadyTime = std::chrono::steady_clock::time_point;

// published = segmented + dropped + rejected, always.
struct Account {
  std::uint64_t published = 0;
  std::uint64_t segmented = 0;
  std::uint64_t dropped = 0;
  std::uint64_t rejected = 0;
  std::map<std::string, std::uint64_t> dropped_by_cause = {};
  std::map<std::string, std::uint64_t> rejected_by_cause = {};
};

// A node's counters over all processes that were the node, one after the other: a process that is
// started again counts from 0.
class NodeTotals {
 public:
  // True if a counter moved.
  bool add(const NodeReport& report);
  [[nodiscard]] const std::optional<NodeReport>& latest() const { return latest_; }
  // The counters of all processes; of everything else, the latest.
  [[nodiscard]] NodeReport total() const;

 private:
  NodeReport earlier_;  // sums over processes that have been replaced
  std::optional<NodeReport> latest_;
};

class FrameAccount {
 public:
  explicit FrameAccount(std::string sensor) : sensor_(std::move(sensor)) {}

  // Reports of other sensors' nodes change nothing.
  void add_report(const NodeReport& report, SteadyTime now);
  void add_segment_list(SteadyTime now) { last_progress_ = now; }

  // The source has ended and every frame that it gave is accounted for: by the segmenter, or, once
  // a second has passed in which nothing moved, as dropped in transport before the segmenter saw
  // it.
  [[nodiscard]] bool complete(SteadyTime now) const;

  // When complete, the frames that the segmenter never saw are dropped ones. Before, only those
  // frames count as published whose fate is known.
  [[nodiscard]] Account account(SteadyTime now) const;

  // Every cloud that the segmenter took was handed over in shared memory without a copy; false
  // before it took one.
  [[nodiscard]] bool zero_copy() const;

  [[nodiscard]] const std::optional<NodeReport>& grabber() const { return grabber_.latest(); }
  [[nodiscard]] const std::optional<NodeReport>& segmenter() const { return segmenter_.latest(); }

 private:
  std::string sensor_;
  NodeTotals grabber_;
  NodeTotals segmenter_;
  bool source_ended_ = false;
  SteadyTime last_progress_{};  // when a counter moved or a segment list came
  SteadyTime last_segmenter_report_{};
};

}  // namespace cleave::client
