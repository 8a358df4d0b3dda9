// SPDX-License-Identifier: BSD-3-Clause
// What a header from the bus must say before anyone believes it: who writes there is not known.
#pragma once

#include <optional>
#include <string_view>

#include "libcleave/types.hpp"
#include "segmentation/segmentation.hpp"
#include "segmenter/pipeline/causes.hpp"

namespace cleave::service {

// The writer still has the memory and may change it at any time: read it once, check the copy, and
// use nothing but the copy.
[[nodiscard]] FrameHeader private_copy(const FrameHeader& shared);

// Empty: width * height points are not more than `capacity`, all names end within their arrays, and
// the frame is of `sensor`.
[[nodiscard]] std::optional<RejectCause> check_header(const FrameHeader& header,
                                                      std::string_view sensor,
                                                      std::size_t capacity);

// A header that may be published: names that do not end, or another sensor's, are replaced.
[[nodiscard]] FrameHeader answerable(FrameHeader header, std::string_view sensor);

[[nodiscard]] std::optional<RejectCause> reject_cause(segmentation::Outcome outcome);
[[nodiscard]] cleave_v1_FrameOutcome wire_outcome(std::optional<RejectCause> cause);

}  // namespace cleave::service
