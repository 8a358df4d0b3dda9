// SPDX-License-Identifier: BSD-3-Clause
// A segmentation in a recording's terms.
#pragma once

#include "console/json.hpp"
#include "recording/frames/frame.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::workbench {

// Sets the segments and borders of the list; the other fields keep what they have.
void set_segments(recording::SegmentList& list, const segmentation::Segmentation& segmentation);

// {"segments": [..], "borders": [..]}, as contract_json() writes them.
[[nodiscard]] Json segments_json(const segmentation::Segmentation& segmentation);

}  // namespace cleave::workbench
