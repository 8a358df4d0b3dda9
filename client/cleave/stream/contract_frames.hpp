// SPDX-License-Identifier: BSD-3-Clause
// Frames between the stream's types and a recording's.
#pragma once

#include <vector>

#include "libcleave/cloud_reader.hpp"
#include "libcleave/cloud_writer.hpp"
#include "libcleave/types.hpp"
#include "recording/frames/frame.hpp"

namespace cleave::client {

// From what came over the stream. A cloud's and a label map's throw recording::DataError for a size
// that cannot be: 0 points, or more than the contract's capacity.
[[nodiscard]] recording::FrameHeader frame_of(const FrameHeader& header);
[[nodiscard]] recording::Cloud frame_of(const CloudSample& cloud);
[[nodiscard]] recording::Labels frame_of(const LabelSample& labels);
[[nodiscard]] recording::SegmentList frame_of(const SegmentList& list);

// Into memory that is to be published, in which the points have room. Throw recording::DataError
// for a name of more than 63 characters.
void fill(FrameHeader& message, const recording::FrameHeader& header);
void fill(const CloudLoan& message, const recording::Cloud& cloud);
void fill(const LabelLoan& message, const recording::Labels& labels);

// A SegmentList and the memory of its sequences.
class SegmentListMessage {
 public:
  // Throws as fill() does.
  explicit SegmentListMessage(const recording::SegmentList& list);
  SegmentListMessage(const SegmentListMessage&) = delete;
  SegmentListMessage& operator=(const SegmentListMessage&) = delete;
  // Its sequences are this object's.
  [[nodiscard]] SegmentList& message() { return message_; }

 private:
  std::vector<SegmentMessage> segments_;
  std::vector<BorderMessage> borders_;
  SegmentList message_{};
};

}  // namespace cleave::client
