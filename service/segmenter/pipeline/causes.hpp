// SPDX-License-Identifier: BSD-3-Clause
// Why a frame has no segments. The names are what the status shows.
#pragma once

#include <array>
#include <cstddef>

namespace cleave::service {

// Dropped: nothing is published for the frame.
enum class DropCause {
  queue,          // live mode: newer frames came while no worker was free
  transport,      // a gap in the frame ids: lost before this process saw it
  no_free_chunk,  // no memory for the label map: readers hoard the pool's chunks
  refused_by_dds  // the results could not be published
};
inline constexpr std::array drop_cause_names = {"queue", "transport", "no free chunk",
                                                "refused by DDS"};

// Rejected: an empty segment list is published that says why.
enum class RejectCause {
  bad_size,
  bad_header,
  no_finite_point,
  segmentation_failed,  // an exception, e.g. out of memory
  too_many_segments,    // more than labels can name
  wrong_unit            // coordinates seem to be millimetres
};
inline constexpr std::array reject_cause_names = {"bad size",          "bad header",
                                                  "no finite point",   "segmentation failed",
                                                  "too many segments", "wrong unit"};

inline constexpr const char* to_string(DropCause cause) {
  return drop_cause_names.at(static_cast<std::size_t>(cause));
}
inline constexpr const char* to_string(RejectCause cause) {
  return reject_cause_names.at(static_cast<std::size_t>(cause));
}

}  // namespace cleave::service
