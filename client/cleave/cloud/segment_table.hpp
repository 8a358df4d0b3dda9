// Segments for people and for programs, whether they were computed here or came over DDS.
#pragma once

#include <string>

#include "cleave/console/json.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::client {

// A line a segment: label, points, centroid, box extent, planarity, and what it touches: the
// neighbours' labels, with '+' behind those across a convex border.
[[nodiscard]] std::string segment_table(const segmentation::Segmentation& segmentation);

// Keys as in the contract's Segment: label, point_count, centroid, mean_normal, box {centre,
// orientation, extent}, rectangle {left, top, right, bottom}, planarity.
[[nodiscard]] Json json_of(const segmentation::Segment& segment);
// {"first": .., "second": .., "kind": "concave" or "convex"}
[[nodiscard]] Json json_of(const segmentation::Border& border);
// {"segments": [..], "borders": [..]}
[[nodiscard]] Json json_of(const segmentation::Segmentation& segmentation);

}  // namespace cleave::client
