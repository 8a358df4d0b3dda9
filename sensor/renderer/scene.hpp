// What stands on the table. Table frame: z up, origin below the camera; metres, radians.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace cleave::render {

struct SceneParameters {
  std::uint32_t seed = 0;
  std::uint32_t min_objects = 6;
  std::uint32_t max_objects = 11;
  double touching = 0.4;  // probability that an object slides into contact with another
  double stacked = 0.25;  // probability that it stands on another
};

// "simple" (2 to 5 objects), "medium" (6 to 11), "crowded" (15 to 24); throws std::invalid_argument
// that lists the names for any other.
[[nodiscard]] SceneParameters scene_parameters(const std::string& name, std::uint32_t seed);

struct CameraPose {
  double height_m = 0.6;  // above the table
  double tilt_rad = 0.68;  // downwards from horizontal
};

}  // namespace cleave::render
