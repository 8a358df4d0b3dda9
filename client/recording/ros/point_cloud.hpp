// SPDX-License-Identifier: BSD-3-Clause
// From PointCloud2 to points.
#pragma once

#include <vector>

#include "recording/ros/messages.hpp"

namespace cleave::recording::ros {

// Throws Unusable unless there are fields x, y and z, each of one of ROS's eight datatypes and
// within a point. Of a field of several elements the first counts; of two fields of a name, too.
void check_fields(const PointCloud2& cloud);

// x, y, z of every point, row-major, padding left out. Where one of the three is not finite, or is
// beyond what a float holds, all are NaN. Allocates no more than three floats a byte of the
// message. Throws Unusable where check_fields() does, where there is no point, or where rows
// overlap or reach beyond the data. Deterministic.
[[nodiscard]] std::vector<float> points_of(const PointCloud2& cloud);

}  // namespace cleave::recording::ros
