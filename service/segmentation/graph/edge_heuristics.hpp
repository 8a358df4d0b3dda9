// SPDX-License-Identifier: BSD-3-Clause
// Equations 4.1 to 4.7: what the border between two patches of surface says about them.
#pragma once

#include "segmentation/graph/surfel.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Equation 4.1: do the surfaces bend away from each other?
[[nodiscard]] bool is_convex(const Surfel& i, const Surfel& j);

// Equation 4.2: does the normal of j lean away from i, seen in the plane of i? The same answer as
// equation 4.1 but for few edges.
[[nodiscard]] bool is_convex_after_lai(const Surfel& i, const Surfel& j);

// Either, as the options say. Of 4.2, which is not symmetric, callers name the lower vertex first.
[[nodiscard]] bool is_convex(const Surfel& i, const Surfel& j, Convexity convexity);

// Equation 4.3 for a concave edge, inverse quadratic or Gaussian, with |n_i - n_j|^2 = 2 - 2
// cos(angle).
[[nodiscard]] float concave_weight(float cos_angle, const GraphOptions& options);

// Equation 4.3: likelihood of the two patches to belong to one object, 0 to 1.
[[nodiscard]] float edge_weight(const Surfel& i, const Surfel& j, const GraphOptions& options);

// Equation 4.4: the angle between the line that joins the patches and the line in which their
// planes meet, 0 to pi/2. A quarter turn where the planes are parallel or the centroids coincide.
[[nodiscard]] float meeting_angle_rad(const Surfel& i, const Surfel& j);

// Equation 4.5: the least meeting angle of patches whose normals differ by `beta_rad`.
[[nodiscard]] float least_meeting_angle_rad(float beta_rad, const GraphOptions& options);

// Equation 4.6: false where two surfaces only happen to touch in a point.
[[nodiscard]] bool is_valid(const Surfel& i, const Surfel& j, const GraphOptions& options);

// How far a patch's centroid is off the other's plane, the mean of both ways: 0 for patches of one
// plane, and of one ball or cylinder of the same size; metres.
[[nodiscard]] float step_m(const Surfel& i, const Surfel& j);

// Is the step more than noise and more than what a crease explains? Centroids of two faces are off
// the mean plane where one is nearer to their crease: here, at most by half of their distance.
[[nodiscard]] bool is_step(const Surfel& i, const Surfel& j, const GraphOptions& options);

// Soft constraints (the thesis's future work): how much of a cannot-link edge a concave edge is
// whose normals differ by `beta_rad`, below the threshold of equation 4.7; 0 to 1, in steps of 1/64
// so that sums of shares are exact.
[[nodiscard]] float cannot_link_share(float beta_rad, const GraphOptions& options);

// The threshold of equation 4.7, given as the angle of a concave edge: below it an edge is
// cannot-link.
[[nodiscard]] float cannot_link_weight(const GraphOptions& options);

}  // namespace cleave::segmentation
