// SPDX-License-Identifier: BSD-3-Clause
// What a planner sees of the stream: segment lists and statuses, collected in the test's own
// process over the public domain (no shared memory: RouDi would end the test with itself).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "libcleave/reader.hpp"
#include "libcleave/status.hpp"
#include "libcleave/stream.hpp"

namespace cleave::test {

struct ListSummary {
  std::uint32_t epoch;
  std::uint64_t frame_id;
  cleave_v1_FrameOutcome outcome;
  std::size_t segments;
  std::uint64_t device_time_us;
  std::int64_t capture_time_ns;
};

class Monitor {
 public:
  Monitor(std::uint32_t domain, const std::string& sensor);

  // Takes what has come in; then the accessors below tell.
  void poll();
  // Whether so many more lists come in.
  [[nodiscard]] bool lists_flow(std::size_t count);
  [[nodiscard]] const std::vector<ListSummary>& lists() const { return lists_; }
  // The node's last status; a default one before the first.
  [[nodiscard]] NodeReport status(const std::string& node) const;
  // All statuses of the node that came in, in order.
  [[nodiscard]] std::vector<NodeReport> history(const std::string& node) const;
  [[nodiscard]] Stream& stream() { return stream_; }

 private:
  Stream stream_;
  Reader<SegmentList> segments_;
  Reader<NodeStatus> statuses_;
  std::vector<ListSummary> lists_;
  std::map<std::string, std::vector<NodeReport>> nodes_;
};

}  // namespace cleave::test
