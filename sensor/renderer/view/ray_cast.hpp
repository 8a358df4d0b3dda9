// SPDX-License-Identifier: BSD-3-Clause
// What the rays of a perfect camera hit: everything about an image that does not depend on noise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sensor/renderer/scene/scene.hpp"
#include "sensor/renderer/view/camera.hpp"
#include "sensor/renderer/view/intersect.hpp"

namespace cleave::render {

inline constexpr std::uint16_t no_surface = 0;
inline constexpr std::uint16_t table_surface = 1;

// Object k of the scene has one surface for each of its parts that a concave crease bounds.
constexpr std::uint16_t object_surface(std::size_t object, Part part) {
  return static_cast<std::uint16_t>(object + 2 + 100 * static_cast<std::size_t>(part));
}

// Row-major images, all of the same size.
struct RayCast {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> depth_m;            // along the optical axis; infinity = nothing was hit
  std::vector<float> cosine;             // of the angle between ray and normal, 0 to 1
  std::vector<std::uint16_t> surface;    // which one was hit
  std::vector<std::uint8_t> measurable;  // 1 = within the crop, seen by projector and camera
};

// One ray through each pixel's centre. A ray is tested against an object only within the image of
// that object's bounding sphere.
[[nodiscard]] RayCast cast_rays(const Scene& scene, const CameraPose& pose,
                                const CameraModel& camera);

}  // namespace cleave::render
