// SPDX-License-Identifier: BSD-3-Clause
// The normal of a plane through points, and how flat they lie, by Principal Component Analysis
// (section 2.1.2.2).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "segmentation/math/moments.hpp"

namespace cleave::segmentation {

// Unit eigenvector of a symmetric matrix's smallest eigenvalue, sign arbitrary. Empty where it is
// not unique to rounding: the points of that covariance lie on a line or in one spot.
[[nodiscard]] std::optional<Eigen::Vector3d> smallest_eigenvector(const Eigen::Matrix3d& matrix);

// Unit vector from `position` to the sensor, which is at the origin; (0, 0, -1) at the origin.
[[nodiscard]] Eigen::Vector3f direction_to_sensor(const Eigen::Vector3f& position);

// `sum` scaled to unit length; the direction to the sensor if it is zero.
[[nodiscard]] Eigen::Vector3f unit_or_towards_sensor(const Eigen::Vector3f& sum,
                                                     const Eigen::Vector3f& position);

// Unit normal at the points' mean, towards the sensor. Where no plane is defined (fewer than three
// points, or on a line): the direction to the sensor itself.
[[nodiscard]] Eigen::Vector3f fit_normal(const Moments& points);

// Equation 2.2: how far from a plane the points lie, 0 (on one) to 1/3. 0 where no point is.
[[nodiscard]] float surface_variation(const Moments& points);

}  // namespace cleave::segmentation
