// SPDX-License-Identifier: BSD-3-Clause
// From a depth Image to depths.
#pragma once

#include <string_view>
#include <vector>

#include "recording/ros/messages.hpp"

namespace cleave::recording::ros {

// Whether an Image's encoding is one of depth (ROS REP 118): 16UC1 and mono16, millimetres, or
// 32FC1, metres. Throws Unusable for any other.
void check_encoding(const Image& image);

// Depth of every pixel in metres, row-major, padding left out; NaN = no measurement, which 16 bits
// write as 0, and 32 as NaN, as infinity, as 0 or as less. Throws Unusable where check_encoding()
// does, where there is no pixel, or where rows overlap or reach beyond the data. Deterministic.
[[nodiscard]] std::vector<float> depth_of(const Image& image);

}  // namespace cleave::recording::ros
