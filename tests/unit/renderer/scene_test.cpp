// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sensor/renderer/scene/random.hpp"

namespace cleave::render {
namespace {

Scene scene_with(std::uint32_t seed, std::uint32_t objects) {
  SceneParameters parameters = scene_parameters("crowded", seed);
  parameters.min_objects = parameters.max_objects = objects;
  return make_scene(parameters);
}

// Whether a point of an object's own frame is in its matter, or in what it encloses. Written anew
// from the shapes' definitions, to check the placement's prisms.
struct Holds {
  Eigen::Vector3d p;

  bool operator()(const Box& s) const {
    return std::abs(p.x()) < s.half_m.x() && std::abs(p.y()) < s.half_m.y() && p.z() > 0 &&
           p.z() < 2 * s.half_m.z();
  }
  bool operator()(const Cylinder& s) const {
    return p.head<2>().norm() < s.radius_m && p.z() > 0 && p.z() < s.height_m;
  }
  bool operator()(const LyingCylinder& s) const {
    return std::hypot(p.y(), p.z() - s.radius_m) < s.radius_m && std::abs(p.x()) < s.half_length_m;
  }
  bool operator()(const Sphere& s) const {
    return (p - Eigen::Vector3d(0, 0, s.radius_m)).norm() < s.radius_m;
  }
  bool operator()(const Bowl& s) const {
    return (p - Eigen::Vector3d(0, 0, s.centre_height_m)).norm() < s.radius_m && p.z() > 0 &&
           p.z() < s.height_m;
  }
  bool operator()(const Mug& s) const {
    if (p.head<2>().norm() < s.radius_m && p.z() > 0 && p.z() < s.height_m) return true;
    if (!s.handle) return false;
    for (const Eigen::Vector3d& joint : handle_polyline(s)) {
      if ((p - joint).norm() < handle_bar_radius_m) return true;
    }
    return false;
  }
};

bool holds(const Object& object, const Eigen::Vector3d& point_m) {
  const Eigen::AngleAxisd turn_back(-object.yaw_rad, Eigen::Vector3d::UnitZ());
  return std::visit(Holds{turn_back * (point_m - object.base_m)}, object.shape);
}

TEST(Scene, HasTheSameObjectsForTheSameSeedAndOthersForAnother) {
  const Scene a = make_scene(scene_parameters("crowded", 5));
  const Scene b = make_scene(scene_parameters("crowded", 5));
  const Scene c = make_scene(scene_parameters("crowded", 6));
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].base_m, b.objects[i].base_m);
    EXPECT_EQ(a.objects[i].yaw_rad, b.objects[i].yaw_rad);
    EXPECT_EQ(a.objects[i].shape.index(), b.objects[i].shape.index());
  }
  EXPECT_NE(a.objects[0].base_m, c.objects[0].base_m);
}

TEST(Scene, PresetsHaveTheirNumbersOfObjects) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const std::size_t simple = make_scene(scene_parameters("simple", seed)).objects.size();
    const std::size_t medium = make_scene(scene_parameters("medium", seed)).objects.size();
    const std::size_t crowded = make_scene(scene_parameters("crowded", seed)).objects.size();
    EXPECT_TRUE(simple >= 2 && simple <= 5) << simple;
    EXPECT_TRUE(medium >= 6 && medium <= 11) << medium;
    EXPECT_TRUE(crowded >= 15 && crowded <= 24) << crowded;
  }
}

TEST(Scene, AnExactNumberOfObjectsIsAlwaysReached) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    for (const std::uint32_t objects : {2U, 12U, 13U, 30U}) {
      EXPECT_EQ(scene_with(seed, objects).objects.size(), objects);
    }
  }
}

TEST(Scene, NumbersOfObjectsThatCannotBeAreRefused) {
  EXPECT_THROW(scene_with(1, 1), std::invalid_argument);
  EXPECT_THROW(scene_with(1, 31), std::invalid_argument);
  SceneParameters upside_down;
  upside_down.min_objects = 9;
  upside_down.max_objects = 8;
  EXPECT_THROW(static_cast<void>(make_scene(upside_down)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(scene_parameters("kitchen", 1)), std::invalid_argument);
}

TEST(Scene, NoObjectReachesIntoAnother) {
  Random random(1);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Scene scene = scene_with(seed, 30);
    for (const Object& object : scene.objects) {
      const BoundingSphere sphere = bounding_sphere(object);
      for (int sample = 0; sample < 2000; ++sample) {
        const Eigen::Vector3d offset{random.uniform(-1, 1), random.uniform(-1, 1),
                                     random.uniform(-1, 1)};
        const Eigen::Vector3d point = sphere.centre_m + sphere.radius_m * offset;
        if (!holds(object, point)) continue;
        EXPECT_GT(point.z(), 0);
        EXPECT_EQ(
            std::ranges::count_if(scene.objects, [&](const Object& o) { return holds(o, point); }),
            1)
            << "seed " << seed;
      }
    }
  }
}

TEST(Scene, EveryObjectStandsOnTheTableOrWithItsCentreOnAFlatTop) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Scene scene = make_scene(scene_parameters("crowded", seed));
    for (const Object& object : scene.objects) {
      if (object.base_m.z() == 0) continue;
      const Eigen::Vector3d below = object.base_m - Eigen::Vector3d(0, 0, 1e-6);
      EXPECT_TRUE(std::ranges::any_of(scene.objects,
                                      [&](const Object& support) {
                                        return has_flat_top(support.shape) && holds(support, below);
                                      }))
          << "seed " << seed;
    }
  }
}

TEST(Scene, SomeObjectsAreStackedAndSomeTouch) {
  int stacked = 0;
  int touching = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Scene scene = make_scene(scene_parameters("crowded", seed));
    for (const Object& object : scene.objects) {
      if (object.base_m.z() > 0) ++stacked;
      Object larger = object;
      auto* const box = std::get_if<Box>(&larger.shape);
      if (box == nullptr) continue;
      box->half_m.head<2>().array() += 0.0025;
      const auto meets = [&](const Object& other) {
        return &other != &object && other.base_m.z() == object.base_m.z() &&
               overlap(footprint(other).front(), footprint(larger).front());
      };
      if (std::ranges::any_of(scene.objects, meets)) ++touching;
    }
  }
  EXPECT_GT(stacked, 20);
  EXPECT_GT(touching, 20);
}

TEST(CameraLoop, IsClosedSmoothAndLooksAtOnePointOfTheTable) {
  const CameraPose base{.height_m = 0.6, .tilt_rad = 0.7, .x_m = 0.1, .y_m = -0.2, .yaw_rad = 0.4};
  const auto target = [](const CameraPose& pose) {
    const Eigen::Isometry3d transform = table_from_camera(pose);
    const Eigen::Vector3d forward = transform.linear().col(2);
    return Eigen::Vector3d(transform.translation() -
                           transform.translation().z() / forward.z() * forward);
  };
  EXPECT_NEAR(
      (table_from_camera(pose_on_loop(base, 0)).matrix() - table_from_camera(base).matrix()).norm(),
      0, 1e-12);
  constexpr int steps = 60;
  Eigen::Vector3d last = table_from_camera(pose_on_loop(base, 0)).translation();
  for (int i = 1; i <= steps; ++i) {
    const CameraPose pose = pose_on_loop(base, static_cast<double>(i) / steps);
    const Eigen::Vector3d position = table_from_camera(pose).translation();
    EXPECT_LT((position - last).norm(), 0.004);
    EXPECT_NEAR((target(pose) - target(base)).norm(), 0, 1e-9);
    last = position;
  }
  EXPECT_NEAR((last - table_from_camera(base).translation()).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace cleave::render
