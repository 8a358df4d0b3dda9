// SPDX-License-Identifier: BSD-3-Clause
// Segment lists in C++ terms: names as text, segments and borders as spans.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "libcleave/reader.hpp"
#include "libcleave/sequence.hpp"

namespace cleave {

// A received list, in place.
class ListSample {
 public:
  explicit ListSample(Sample<SegmentList> list) : list_(std::move(list)) {}

  [[nodiscard]] const FrameHeader& header() const { return list_->header; }
  [[nodiscard]] std::string_view sensor() const { return name_of(list_->header.sensor); }
  // In the order of their labels 1, 2, ...: the first has most points.
  [[nodiscard]] std::span<const SegmentMessage> segments() const {
    return elements_of(list_->segments);
  }
  // Pairs of segments that touch, and how.
  [[nodiscard]] std::span<const BorderMessage> borders() const {
    return elements_of(list_->borders);
  }
  // False: the frame was refused, message().outcome says why, and there are no segments.
  [[nodiscard]] bool segmented() const { return list_->outcome == cleave_v1_OUTCOME_SEGMENTED; }
  // All fields, as idl/cleave_v1.idl has them.
  [[nodiscard]] const SegmentList& message() const { return *list_; }

 private:
  Sample<SegmentList> list_;
};

// One thread takes; wait with a WaitSet.
class ListReader : private Reader<SegmentList> {
 public:
  using Reader::live_writers;
  using Reader::raw;
  using Reader::Reader;

  // The oldest list that waits; empty when there is none.
  [[nodiscard]] std::optional<ListSample> take() {
    std::optional<Sample<SegmentList>> list = Reader::take();
    if (!list) return std::nullopt;
    return ListSample(std::move(*list));
  }
};

}  // namespace cleave
