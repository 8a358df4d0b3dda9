// SPDX-License-Identifier: BSD-3-Clause
// A structured-light camera measures only what its projector lights and its infrared camera sees.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "sensor/renderer/view/ray_cast.hpp"

namespace cleave::render {

// Along the optical frame's x, seen from where the depth image is registered to. As in the real
// table-top scenes the wide shadow, the projector's, falls to the left of an object.
inline constexpr double projector_x_m = 0.050;
inline constexpr double infrared_camera_x_m = -0.025;

// Clears `measurable` where an object stands between the hit point and one of the two. `normals`
// are the hits' in the optical frame.
void remove_shadows(const Scene& scene, const Eigen::Isometry3d& table_from_camera,
                    const CameraModel& camera, const std::vector<Eigen::Vector3f>& normals,
                    RayCast& image);

}  // namespace cleave::render
