// SPDX-License-Identifier: BSD-3-Clause
// A tight box around points.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "segmentation/graph/surfel.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::segmentation {

// The normal that most of the surface shares: of a box that is seen over its edge, that of the face
// that shows most. Not empty.
[[nodiscard]] Eigen::Vector3f dominant_normal(std::span<const Surfel> surface);

// Axes of a box of small volume around `surface`. One axis is a column of `candidate_axes` (unit
// vectors); the two across it are turned to where the volume is least, in steps of five degrees.
// Columns: the box's axes, right-handed. Not empty.
[[nodiscard]] Eigen::Matrix3f box_axes(std::span<const Surfel> surface,
                                       std::span<const Eigen::Vector3f> candidate_axes);

// Names the axes by decreasing extent; `low` and `high` are the points' limits along the axes.
[[nodiscard]] OrientedBox make_box(const Eigen::Matrix3f& axes, const Eigen::Vector3f& low,
                                   const Eigen::Vector3f& high);

}  // namespace cleave::segmentation
