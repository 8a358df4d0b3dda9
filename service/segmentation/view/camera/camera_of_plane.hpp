// SPDX-License-Identifier: BSD-3-Clause
// What camera sees a plane as it is seen: of the many that do, the one with square pixels whose
// axis goes through the middle of the image.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/view/camera/camera.hpp"
#include "segmentation/view/camera/pixel_sample.hpp"

namespace cleave::segmentation {

struct ScenePlane {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns, right-handed; the normal last
  double height = 0;    // along the normal, above `middle`, in extents
  double flatness = 1;  // thickness over length; 0 = flat
};

// Through the points that are not many times `extent_m` off `middle`.
[[nodiscard]] ScenePlane plane_through(const std::vector<SampledPixel>& pixels,
                                       const Eigen::Vector3d& middle, double extent_m);

// `homography` takes (s, t, 1) of the plane to the image, both about 1 large, with the middle of
// the image at 0. The camera is in coordinates (s, t, height). Where the plane is seen face on, the
// focal length is a guess.
[[nodiscard]] Camera camera_of_plane(const Eigen::Matrix3d& homography);

}  // namespace cleave::segmentation
