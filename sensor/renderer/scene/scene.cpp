// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/scene.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "sensor/renderer/scene/placement.hpp"
#include "sensor/renderer/scene/random.hpp"

namespace cleave::render {
namespace {

struct Preset {
  std::uint32_t min_objects, max_objects;
  double touching, stacked;
};
constexpr std::array<std::string_view, 3> names = {"simple", "medium", "crowded"};
constexpr std::array<Preset, 3> presets = {
    {{2, 5, 0.35, 0.25}, {6, 11, 0.4, 0.25}, {15, 24, 0.5, 0.3}}};

// More objects than this need a larger part of the table, and are a little smaller.
constexpr std::uint32_t many_objects = 12;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

void check(const SceneParameters& p) {
  if (p.min_objects >= fewest_objects && p.max_objects <= most_objects &&
      p.min_objects <= p.max_objects) {
    return;
  }
  throw std::invalid_argument("a scene of " + std::to_string(p.min_objects) + " to " +
                              std::to_string(p.max_objects) + " objects was asked for; it holds " +
                              std::to_string(fewest_objects) + " to " +
                              std::to_string(most_objects));
}

}  // namespace

std::span<const std::string_view> preset_names() {
  return names;
}

SceneParameters scene_parameters(std::string_view name, std::uint32_t seed) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != name) continue;
    return {seed, presets[i].min_objects, presets[i].max_objects, presets[i].touching,
            presets[i].stacked};
  }
  throw std::invalid_argument("unknown scene \"" + std::string(name) +
                              "\"; known are simple, medium, crowded");
}

Scene make_scene(const SceneParameters& parameters) {
  check(parameters);
  Random random(parameters.seed);
  Scene scene;
  scene.camera.height_m = random.uniform(0.55, 0.68);
  scene.camera.tilt_rad = radians(random.uniform(34, 44));
  const std::uint32_t count =
      parameters.min_objects + random.below(parameters.max_objects - parameters.min_objects + 1);
  const bool many = count > many_objects;
  const double centre_y =
      scene.camera.height_m / std::tan(scene.camera.tilt_rad) + random.uniform(0, 0.1);
  const PlacementArea area{{0, centre_y}, {many ? 0.36 : 0.26, many ? 0.30 : 0.18}};

  scene.objects = place_objects(count, many ? 1.0 : 1.15, area,
                                {parameters.touching, parameters.stacked}, random);
  scene.crop.y_max_m = centre_y + random.uniform(0.42, 0.62);
  scene.crop.x_min_m = -random.uniform(0.5, 0.9);
  scene.crop.x_max_m = random.uniform(0.45, 0.8);
  scene.crop.columns = 560 + random.below(25);
  return scene;
}

}  // namespace cleave::render
