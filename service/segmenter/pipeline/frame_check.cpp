// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/frame_check.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>

namespace cleave::service {
namespace {

bool ends(const char (&text)[64]) {
  return std::find(std::begin(text), std::end(text), '\0') != std::end(text);
}

}  // namespace

FrameHeader private_copy(const FrameHeader& shared) {
  FrameHeader copy;
  std::memcpy(&copy, &shared, sizeof copy);
  // Keeps the compiler from reading the shared memory again where the copy is used.
  std::atomic_signal_fence(std::memory_order_seq_cst);
  return copy;
}

std::optional<RejectCause> check_header(const FrameHeader& header, std::string_view sensor,
                                        std::size_t capacity) {
  if (!ends(header.sensor) || !ends(header.coordinate_frame) || !ends(header.parent_frame)) {
    return RejectCause::bad_header;
  }
  if (name_of(header.sensor) != sensor) return RejectCause::bad_header;
  const std::uint64_t points = point_count(header);
  if (points == 0 || points > capacity) return RejectCause::bad_size;
  return std::nullopt;
}

FrameHeader answerable(FrameHeader header, std::string_view sensor) {
  std::fill(std::begin(header.sensor), std::end(header.sensor), '\0');
  sensor.copy(header.sensor, sizeof header.sensor - 1);
  if (!ends(header.coordinate_frame)) header.coordinate_frame[0] = '\0';
  if (!ends(header.parent_frame)) header.parent_frame[0] = '\0';
  return header;
}

std::optional<RejectCause> reject_cause(segmentation::Outcome outcome) {
  switch (outcome) {
    case segmentation::Outcome::segmented:
      return std::nullopt;
    case segmentation::Outcome::bad_size:
      return RejectCause::bad_size;
    case segmentation::Outcome::too_many_segments:
      return RejectCause::too_many_segments;
    case segmentation::Outcome::no_finite_point:
      break;
  }
  return RejectCause::no_finite_point;
}

cleave_v1_FrameOutcome wire_outcome(std::optional<RejectCause> cause) {
  if (!cause) return cleave_v1_OUTCOME_SEGMENTED;
  switch (*cause) {
    case RejectCause::bad_size:
      return cleave_v1_OUTCOME_REJECTED_BAD_SIZE;
    case RejectCause::bad_header:
      return cleave_v1_OUTCOME_REJECTED_BAD_HEADER;
    case RejectCause::no_finite_point:
      return cleave_v1_OUTCOME_REJECTED_NO_FINITE_POINT;
    case RejectCause::too_many_segments:
      return cleave_v1_OUTCOME_REJECTED_TOO_MANY_SEGMENTS;
    case RejectCause::wrong_unit:
      return cleave_v1_OUTCOME_REJECTED_WRONG_UNIT;
    case RejectCause::segmentation_failed:
      break;
  }
  return cleave_v1_OUTCOME_REJECTED_SEGMENTATION_FAILED;
}

}  // namespace cleave::service
