// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/ray_cast.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sensor/renderer/view/object_view.hpp"

namespace cleave::render {
namespace {

const CameraPose pose{.height_m = 0.6, .tilt_rad = 0.7};

Scene scene_of(std::vector<Object> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.camera = pose;
  scene.crop = {.x_min_m = -9, .x_max_m = 9, .y_max_m = 9, .columns = 640};
  return scene;
}

// The direction through pixel i of a 640 pixels wide image.
Eigen::Vector3d direction_through(std::size_t i) {
  const std::size_t row = i / 640;
  return pixel_direction(static_cast<double>(i % 640), static_cast<double>(row), {});
}

Eigen::Vector3d point_in_table_frame(const RayCast& image, std::size_t i) {
  return table_from_camera(pose) * (image.depth_m[i] * direction_through(i));
}

TEST(RayCast, TheTablesDepthIsThatOfAPlane) {
  const RayCast image = cast_rays(scene_of({}), pose, {});
  for (std::uint32_t y = 0; y < 480; y += 7) {
    for (std::uint32_t x = 0; x < 640; x += 7) {
      const double v = (y - 239.5) / 525;
      const double expected_m = 0.6 / (std::sin(0.7) + v * std::cos(0.7));
      const std::size_t i = std::size_t{y} * 640 + x;
      EXPECT_EQ(image.surface[i], table_surface);
      EXPECT_NEAR(image.depth_m[i], expected_m, 1e-6);
    }
  }
}

TEST(RayCast, NothingIsSeenAboveTheHorizon) {
  const CameraPose level{.height_m = 0.6, .tilt_rad = 0};
  const RayCast image = cast_rays(scene_of({}), level, {});
  EXPECT_TRUE(std::isinf(image.depth_m[0]));
  EXPECT_EQ(image.surface[0], no_surface);
  EXPECT_EQ(image.measurable[0], 0);
}

TEST(RayCast, ASpheresPixelsLieOnTheSphereAndItsOutlineIsComplete) {
  const Object sphere{Sphere{0.05}, {0.03, 0.7, 0}, 0.3};
  const Eigen::Vector3d centre(0.03, 0.7, 0.05);
  const RayCast image = cast_rays(scene_of({sphere}), pose, {});
  const Eigen::Isometry3d transform = table_from_camera(pose);
  const Eigen::Vector3d to_centre = transform.inverse() * centre;
  int pixels = 0;
  for (std::size_t i = 0; i < image.surface.size(); ++i) {
    const Eigen::Vector3d ray = direction_through(i).normalized();
    const double distance_m = (to_centre - to_centre.dot(ray) * ray).norm();
    if (std::abs(distance_m - 0.05) > 1e-9) {
      EXPECT_EQ(image.surface[i] == object_surface(0, outside_part), distance_m < 0.05);
    }
    if (image.surface[i] == table_surface || image.surface[i] == no_surface) continue;
    ++pixels;
    const Eigen::Vector3d normal = (point_in_table_frame(image, i) - centre) / 0.05;
    EXPECT_NEAR(normal.norm(), 1, 1e-4);
    EXPECT_NEAR(image.cosine[i], -normal.dot(transform.linear() * ray), 1e-3);
  }
  EXPECT_GT(pixels, 2000);
}

TEST(RayCast, ABoxesPixelsLieOnItsTopOrItsSides) {
  const Object box{Box{{0.08, 0.05, 0.04}}, {-0.05, 0.75, 0}, 0.5};
  const RayCast image = cast_rays(scene_of({box}), pose, {});
  const Eigen::AngleAxisd turn_back(-0.5, Eigen::Vector3d::UnitZ());
  int top = 0;
  int sides = 0;
  for (std::size_t i = 0; i < image.surface.size(); ++i) {
    if (image.surface[i] != object_surface(0, outside_part)) continue;
    const Eigen::Vector3d p = turn_back * (point_in_table_frame(image, i) - box.base_m);
    const bool within = std::abs(p.x()) < 0.08 + 1e-6 && std::abs(p.y()) < 0.05 + 1e-6 &&
                        p.z() > -1e-6 && p.z() < 0.08 + 1e-6;
    EXPECT_TRUE(within);
    const bool on_top = std::abs(p.z() - 0.08) < 1e-6;
    const bool on_side =
        std::abs(std::abs(p.x()) - 0.08) < 1e-6 || std::abs(std::abs(p.y()) - 0.05) < 1e-6;
    EXPECT_TRUE(on_top || on_side);
    (on_top ? top : sides) += 1;
  }
  EXPECT_GT(top, 1000);
  EXPECT_GT(sides, 1000);
}

TEST(RayCast, CylindersLieOnTheirWallsAndEnds) {
  const Object upright{Cylinder{0.04, 0.1}, {-0.12, 0.75, 0}, 0};
  const Object lying{LyingCylinder{0.04, 0.09}, {0.12, 0.75, 0}, 0.8};
  const RayCast image = cast_rays(scene_of({upright, lying}), pose, {});
  const Eigen::AngleAxisd turn_back(-0.8, Eigen::Vector3d::UnitZ());
  int hits[2] = {0, 0};
  for (std::size_t i = 0; i < image.surface.size(); ++i) {
    const Eigen::Vector3d p = point_in_table_frame(image, i);
    if (image.surface[i] == object_surface(0, outside_part)) {
      ++hits[0];
      const double radius_m = (p - upright.base_m).head<2>().norm();
      EXPECT_TRUE(std::abs(radius_m - 0.04) < 1e-6 || std::abs(p.z() - 0.1) < 1e-6);
      EXPECT_LT(radius_m, 0.04 + 1e-6);
    } else if (image.surface[i] == object_surface(1, outside_part)) {
      ++hits[1];
      const Eigen::Vector3d local = turn_back * (p - lying.base_m);
      const double radius_m = std::hypot(local.y(), local.z() - 0.04);
      EXPECT_TRUE(std::abs(radius_m - 0.04) < 1e-6 || std::abs(std::abs(local.x()) - 0.09) < 1e-6);
      EXPECT_LT(radius_m, 0.04 + 1e-6);
    }
  }
  EXPECT_GT(hits[0], 3000);
  EXPECT_GT(hits[1], 3000);
}

TEST(RayCast, VesselsShowTheirInsideWithinTheirRim) {
  const Object bowl{Bowl{0.08, 0.075, 0.07, 0.005}, {-0.12, 0.75, 0}, 0};
  const Object mug{Mug{0.04, 0.1, 0.005, true}, {0.12, 0.75, 0}, -0.6};
  const RayCast image = cast_rays(scene_of({bowl, mug}), pose, {});
  int bowl_hollow = 0;
  int mug_hollow = 0;
  int handle = 0;
  for (std::size_t i = 0; i < image.surface.size(); ++i) {
    const Eigen::Vector3d p = point_in_table_frame(image, i);
    if (image.surface[i] == object_surface(0, hollow_part)) {
      ++bowl_hollow;
      const double distance_m = (p - bowl.base_m - Eigen::Vector3d(0, 0, 0.075)).norm();
      EXPECT_TRUE(std::abs(distance_m - 0.075) < 1e-6 || std::abs(p.z() - 0.005) < 1e-6);
    } else if (image.surface[i] == object_surface(1, hollow_part)) {
      ++mug_hollow;
      EXPECT_NEAR((p - mug.base_m).head<2>().norm(), 0.035, 1e-6);
    } else if (image.surface[i] == object_surface(1, handle_part)) {
      ++handle;
      EXPECT_GT((p - mug.base_m).head<2>().norm(), 0.04 - 1e-6);
    }
  }
  EXPECT_GT(bowl_hollow, 1000);
  EXPECT_GT(mug_hollow, 300);
  EXPECT_GT(handle, 300);
}

// The same image without rectangles, which only save time.
TEST(RayCast, MeetsWhatARayAgainstEveryObjectMeets) {
  const Scene scene = make_scene(scene_parameters("crowded", 11));
  const RayCast image = cast_rays(scene, scene.camera, {});
  const Eigen::Isometry3d transform = table_from_camera(scene.camera);
  for (std::size_t i = 0; i < image.surface.size(); i += 13) {
    const Eigen::Vector3d direction = transform.linear() * direction_through(i);
    double nearest_m = direction.z() < 0 ? -transform.translation().z() / direction.z()
                                         : std::numeric_limits<double>::infinity();
    for (const Object& object : scene.objects) {
      const Eigen::AngleAxisd turn_back(-object.yaw_rad, Eigen::Vector3d::UnitZ());
      Hit hit;
      intersect(object.shape,
                {turn_back * (transform.translation() - object.base_m), turn_back * direction},
                hit);
      nearest_m = std::min(nearest_m, hit.t);
    }
    if (std::isinf(nearest_m)) {
      EXPECT_TRUE(std::isinf(image.depth_m[i]));
    } else {
      EXPECT_NEAR(image.depth_m[i], nearest_m, 1e-6);
    }
  }
}

TEST(RayCast, ATallBoxThrowsAWideShadowToItsLeftAndANarrowOneToItsRight) {
  const Object box{Box{{0.05, 0.05, 0.1}}, {0, 0.8, 0}, 0};
  const RayCast image = cast_rays(scene_of({box}), pose, {});
  int left = 0;
  int right = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const std::size_t i = std::size_t{y} * image.width + x;
      if (image.surface[i] != table_surface || image.measurable[i] != 0) continue;
      (x < 320 ? left : right) += 1;
    }
  }
  EXPECT_GT(right, 300);
  EXPECT_NEAR(left, 2 * right, 0.3 * left);
}

// Walks along the line in small steps.
bool box_stands_between(const Object& object, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& to) {
  const Eigen::Vector3d half_m = std::get<Box>(object.shape).half_m;
  const Eigen::AngleAxisd turn_back(-object.yaw_rad, Eigen::Vector3d::UnitZ());
  constexpr int steps = 2000;
  for (int step = 1; step < steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    const Eigen::Vector3d p = turn_back * (from + share * (to - from) - object.base_m);
    if (std::abs(p.x()) < half_m.x() && std::abs(p.y()) < half_m.y() && p.z() < 2 * half_m.z()) {
      return true;
    }
  }
  return false;
}

TEST(RayCast, ShadowsAreWhereTheBoxStandsBetweenTheTableAndASource) {
  const Object box{Box{{0.05, 0.04, 0.08}}, {0.05, 0.8, 0}, 0.4};
  const RayCast image = cast_rays(scene_of({box}), pose, {});
  const Eigen::Isometry3d transform = table_from_camera(pose);
  int hidden = 0;
  int disagree = 0;
  for (std::size_t i = 0; i < image.surface.size(); i += 5) {
    const Eigen::Vector3d point = point_in_table_frame(image, i);
    if (image.surface[i] != table_surface || (point - box.base_m).norm() > 0.3) continue;
    bool seen = true;
    for (const double source_x_m : {0.050, -0.025}) {
      const Eigen::Vector3d source = transform * Eigen::Vector3d(source_x_m, 0, 0);
      seen = seen && !box_stands_between(box, point, source);
    }
    if (!seen) ++hidden;
    if (seen != (image.measurable[i] != 0)) ++disagree;
  }
  EXPECT_GT(hidden, 60);
  EXPECT_LE(disagree, 2);  // where the line cuts a corner between two steps
}

}  // namespace
}  // namespace cleave::render
