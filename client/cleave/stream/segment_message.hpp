// Segment lists as they come over DDS, in the terms of the segmentation library.
#pragma once

#include <string>

#include "cleave/console/json.hpp"
#include "libcleave/types.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::client {

[[nodiscard]] segmentation::Segmentation segmentation_of(const SegmentList& list);

// "segmented", or why the frame was rejected: "bad size", "bad header", "no finite point", ....
[[nodiscard]] const char* outcome_of(const SegmentList& list);

// What `cleave echo` prints: a line of the header, a line of the outcome, a table of the segments.
[[nodiscard]] std::string text_of(const SegmentList& list);

// Keys as in the contract: header, cloud_publication_time_ns,
// cloud_reception_time_ns, outcome, segments, borders, queue_ms,
// segmentation_ms.
[[nodiscard]] Json json_of(const SegmentList& list);

}  // namespace cleave::client
