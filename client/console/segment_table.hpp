// SPDX-License-Identifier: BSD-3-Clause
// Segments for people.
#pragma once

#include <string>

#include "recording/frames/frame.hpp"

namespace cleave {

// A line a segment: label, points, centroid, box extent, planarity, and what it touches: the
// neighbours' labels, with '+' behind those across a convex border.
[[nodiscard]] std::string segment_table(const recording::SegmentList& list);

}  // namespace cleave
