// SPDX-License-Identifier: BSD-3-Clause
// What stands on the table, by seed. Table frame: z up, origin below the camera; metres, radians.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "sensor/renderer/scene/object.hpp"
#include "sensor/renderer/view/camera.hpp"

namespace cleave::render {

inline constexpr std::uint32_t fewest_objects = 2;
inline constexpr std::uint32_t most_objects = 30;

struct SceneParameters {
  std::uint32_t seed = 1;
  std::uint32_t min_objects = 6;
  std::uint32_t max_objects = 11;
  // Shares of the attempts to place an object; those that do not fit are made anew.
  double touching = 0.4;  // slides into contact with another
  double stacked = 0.25;  // stands on another
};

// The names that scene_parameters() knows.
[[nodiscard]] std::span<const std::string_view> preset_names();

// "simple" (2 to 5 objects), "medium" (6 to 11), "crowded" (15 to 24); throws std::invalid_argument
// that lists the names for any other.
[[nodiscard]] SceneParameters scene_parameters(std::string_view name, std::uint32_t seed);

// The part of the image that is kept: real data sets are cropped to their table, too.
struct Crop {
  double x_min_m = -1;  // of the table's points
  double x_max_m = 1;
  double y_max_m = 2;
  std::uint32_t columns = 640;  // of an image 640 wide, from the left; in proportion of others
};

struct Scene {
  std::vector<Object> objects;
  CameraPose camera;
  Crop crop;
};

// Deterministic. The number of objects is always one between the parameters' bounds: where the
// table is full, objects get smaller until they fit. Objects do not interpenetrate; each stands on
// the table or, with its centre, on a flat top. Throws std::invalid_argument if the bounds are not
// in order or not within 2 to 30.
[[nodiscard]] Scene make_scene(const SceneParameters& parameters);

}  // namespace cleave::render
