// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/random_object.hpp"

#include <numbers>

namespace cleave::render {
namespace {

// Braced lists everywhere below: only they fix the order in which random numbers are drawn.

Box random_box(Random& random, double scale) {
  Eigen::Vector3d half_m{random.uniform(0.03, 0.11), random.uniform(0.025, 0.08),
                         random.uniform(0.02, 0.1)};
  if (random.chance(0.3)) half_m.z() = random.uniform(0.08, 0.13);
  return {scale * half_m};
}

Box random_book(Random& random, double scale) {
  const Eigen::Vector3d half_m{random.uniform(0.08, 0.13), random.uniform(0.055, 0.09),
                               random.uniform(0.011, 0.022)};
  return {scale * half_m};
}

Bowl random_bowl(Random& random, double scale) {
  const double radius_m = scale * random.uniform(0.06, 0.09);
  const double wall_m = random.uniform(0.004, 0.006);
  const double centre_height_m = radius_m * random.uniform(0.88, 0.97);
  const double height_m = centre_height_m * random.uniform(0.75, 1.0);
  return {radius_m, centre_height_m, height_m, wall_m};
}

Mug random_mug(Random& random, double scale) {
  return {scale * random.uniform(0.035, 0.05), scale * random.uniform(0.08, 0.12),
          random.uniform(0.004, 0.006), random.chance(0.7)};
}

Shape random_shape(Random& random, double scale) {
  const double share = random.uniform(0, 1);
  if (share < 0.45) return random_box(random, scale);
  if (share < 0.54) return random_book(random, scale);
  if (share < 0.74) {
    return Cylinder{scale * random.uniform(0.028, 0.06), scale * random.uniform(0.06, 0.24)};
  }
  if (share < 0.84) {
    return LyingCylinder{scale * random.uniform(0.028, 0.05), scale * random.uniform(0.05, 0.12)};
  }
  if (share < 0.90) return Sphere{scale * random.uniform(0.03, 0.06)};
  if (share < 0.95) return random_bowl(random, scale);
  return random_mug(random, scale);
}

}  // namespace

Object random_object(Random& random, double scale) {
  Object object{random_shape(random, scale)};
  object.yaw_rad = random.uniform(0, 2 * std::numbers::pi);
  return object;
}

}  // namespace cleave::render
