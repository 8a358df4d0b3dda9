// SPDX-License-Identifier: BSD-3-Clause
// A segmentation in the contract's terms.
#pragma once

#include <vector>

#include "libcleave/types.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::service {

// A SegmentList and the memory of its sequences, reused from frame to frame. One thread at a time.
class SegmentListBuffer {
 public:
  // Sets `segments` and `borders` of the list; the other fields keep what they have.
  void fill(const segmentation::Segmentation& segmentation);
  // Valid until the next fill(); its sequences are this object's (_release is false).
  [[nodiscard]] SegmentList& list() { return list_; }

 private:
  SegmentList list_{};
  std::vector<SegmentMessage> segments_;
  std::vector<BorderMessage> borders_;
};

}  // namespace cleave::service
