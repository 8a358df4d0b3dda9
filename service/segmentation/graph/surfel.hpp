// SPDX-License-Identifier: BSD-3-Clause
// A small piece of surface.
#pragma once

#include <Eigen/Core>

namespace cleave::segmentation {

struct Surfel {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  // metres, sensor frame
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();    // unit length, towards the sensor
};

}  // namespace cleave::segmentation
