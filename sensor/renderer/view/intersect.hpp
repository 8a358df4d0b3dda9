// SPDX-License-Identifier: BSD-3-Clause
// Where a ray meets a shape.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "sensor/renderer/scene/object.hpp"

namespace cleave::render {

// Points origin + t * direction with t > 0, in the shape's own frame.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
};

// The faces of an object that a segmentation ought to tell apart, as concave creases part them.
enum Part { outside_part = 0, hollow_part = 1, floor_part = 2, handle_part = 3 };

struct Hit {
  double t = std::numeric_limits<double>::infinity();  // none yet
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    // unit length, towards the ray's origin
  Part part = outside_part;
};

// Replaces `nearest` by the ray's first hit of the shape if that is nearer.
void intersect(const Shape& shape, const Ray& ray, Hit& nearest);

}  // namespace cleave::render
