// SPDX-License-Identifier: BSD-3-Clause
#include "recording/units/suspected_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "recording/pcd/folder.hpp"
#include "tests/support/box_scene.hpp"
#include "tests/support/data_folder.hpp"
#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::recording {
namespace {

using Points = std::vector<float>;

Points scaled(Points xyz, float factor) {
  for (float& value : xyz) value *= factor;
  return xyz;
}

Points whole(Points xyz) {
  for (float& value : xyz) value = std::round(value);
  return xyz;
}

// The measured points alone, in any order.
Points scattered(const Points& xyz) {
  std::vector<std::array<float, 3>> points;
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    if (std::isfinite(xyz[i])) points.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
  }
  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  Points result;
  for (const auto& p : points) result.insert(result.end(), p.begin(), p.end());
  return result;
}

bool is_suspected(const Points& xyz) {
  return suspected_unit(xyz).has_value();
}

TEST(SuspectedUnit, OfACameraIsMillimetresOnceItIs) {
  const Points metres = tests::render_touching_boxes().xyz;
  const Points millimetres = scaled(metres, 1000);

  EXPECT_FALSE(is_suspected(metres));
  EXPECT_FALSE(is_suspected(scattered(metres)));
  EXPECT_TRUE(is_suspected(millimetres));
  EXPECT_TRUE(is_suspected(scattered(millimetres)));
  EXPECT_TRUE(is_suspected(whole(millimetres))) << "as a time-of-flight camera writes them";
  EXPECT_NE(suspected_unit(millimetres)->evidence.find("camera"), std::string::npos);
}

TEST(SuspectedUnit, OfARoomIsMillimetresToo) {
  const Points room = scaled(tests::render_touching_boxes().xyz, 6);

  EXPECT_FALSE(is_suspected(room));
  EXPECT_TRUE(is_suspected(scaled(room, 1000)));
}

TEST(SuspectedUnit, IsToldFromDepthsThatAreWholeNumbersWhereTheyAreNear) {
  // A camera for close work, 70 mm before a part.
  Points near = scaled(tests::render_touching_boxes().xyz, 100);
  for (std::size_t i = 0; i < near.size(); i += 3) {
    const float depth = std::round(near[i + 2]);
    const float factor = depth / near[i + 2];
    for (std::size_t axis = 0; axis < 3; ++axis) near[i + axis] *= factor;
    near[i + 2] = depth;
  }

  EXPECT_TRUE(is_suspected(near));
}

TEST(SuspectedUnit, OfACameraIsMillimetresHoweverUnevenItsPointsLieInSpace) {
  // Half of the pixels on a part before the camera, half on a wall: a thousand times as dense.
  Points xyz;
  for (int i = 0; i < 640 * 480; ++i) {
    const float u = static_cast<float>(i % 640 - 320) / 525;
    const float v = static_cast<float>(i / 640 - 240) / 525;
    const float z = i / 640 < 240 ? 300 : 10000;
    xyz.insert(xyz.end(), {u * z, v * z, z});
  }

  EXPECT_TRUE(is_suspected(xyz));
}

TEST(SuspectedUnit, IsNotMisledByWhatWasNotMeasured) {
  Points xyz = scaled(tests::render_touching_boxes().xyz, 1000);
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    if (!std::isfinite(xyz[i]) || i % 7 == 0) std::fill_n(&xyz[i], 3, 0.0F);
  }

  EXPECT_TRUE(is_suspected(xyz));
}

// Rings of a turning lidar in a hall of 2 `half_m` by 2 `half_m`, `up` the axis of height.
Points lidar(float half_m, int rings, std::size_t up) {
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 0.02F);
  Points xyz;
  for (int ring = 0; ring < rings; ++ring) {
    const float elevation = 0.35F * (static_cast<float>(ring) / static_cast<float>(rings) - 0.7F);
    for (int step = 0; step < 1800; ++step) {
      const float azimuth = static_cast<float>(step) * std::numbers::pi_v<float> / 900;
      const float x = std::cos(azimuth), y = std::sin(azimuth), z = std::tan(elevation);
      float range = half_m / std::max(std::abs(x), std::abs(y));
      if (z < 0) range = std::min(range, -1.8F / z);
      range += noise(random);
      const std::array<float, 3> p = {x * range, y * range, z * range};
      for (std::size_t axis = 0; axis < 3; ++axis) xyz.push_back(p[(axis + 2 - up + 3) % 3]);
    }
  }
  return xyz;
}

TEST(SuspectedUnit, OfALidarIsNone) {
  for (const float half_m : {4.0F, 30.0F, 200.0F}) {
    for (const std::size_t up : {0U, 1U, 2U}) EXPECT_FALSE(is_suspected(lidar(half_m, 64, up)));
  }
}

// Hills of 2 * `relief` around `height`; a model's regular steps, or a laser's irregular ones.
Points terrain(float step, float height, float relief, bool regular, float east = 0) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> jitter(-0.5F, 0.5F);
  Points xyz;
  for (int i = 0; i < 200 * 200; ++i) {
    const float dx = regular ? 0 : jitter(random), dy = regular ? 0 : jitter(random);
    const float x = step * (static_cast<float>(i % 200 - 100) + dx);
    const float y = step * (static_cast<float>(i / 200 - 100) + dy);
    const float hill = std::sin(x / (30 * step)) * std::cos(y / (40 * step));
    xyz.insert(xyz.end(), {east + x, east + y, height + relief * hill + 0.1F * jitter(random)});
  }
  return xyz;
}

// Those high above the origin of their map are the hard ones: they look as if seen from below.
TEST(SuspectedUnit, OfTerrainIsNone) {
  for (const float step : {0.25F, 1.0F, 5.0F, 30.0F}) {
    for (const float height : {0.0F, 120.0F, 800.0F, 3000.0F}) {
      for (const float relief : {0.0F, 5.0F, 60.0F}) {
        for (const bool regular : {false, true}) {
          const Points hills = terrain(step, height, relief, regular);
          EXPECT_FALSE(is_suspected(hills)) << step << " " << height << " " << relief;
          EXPECT_FALSE(is_suspected(whole(hills))) << step << " " << height << " " << relief;
        }
      }
    }
  }
  EXPECT_FALSE(is_suspected(terrain(1, 500, 20, true, 1e6F)));
}

TEST(SuspectedUnit, OfACloudInAMapsFrameIsNone) {
  for (const float offset : {100.0F, 1e4F, 1e6F}) {
    Points xyz = tests::render_touching_boxes().xyz;
    for (float& value : xyz) value += offset;
    EXPECT_FALSE(is_suspected(xyz)) << offset;
  }
}

TEST(SuspectedUnit, OfAnAirborneCameraWithALongLensIsNone) {
  Points xyz;
  for (int i = 0; i < 200 * 200; ++i) {
    const float u = static_cast<float>(i % 200 - 100) / 3000;
    const float v = static_cast<float>(i / 200 - 100) / 3000;
    const float z = 120 + 5 * std::sin(40 * u) * std::cos(30 * v);
    xyz.insert(xyz.end(), {u * z, v * z, z});
  }

  EXPECT_FALSE(is_suspected(xyz));
}

TEST(SuspectedUnit, OfNothingFewAndDegeneratePointsIsNone) {
  constexpr float infinity = std::numeric_limits<float>::infinity();

  EXPECT_FALSE(is_suspected({}));
  EXPECT_FALSE(is_suspected({100, 200, 900}));
  EXPECT_FALSE(is_suspected(Points(3000, 500)));
  EXPECT_FALSE(is_suspected(Points(3000, infinity)));
  EXPECT_FALSE(is_suspected(Points(3000, 3e38F)));
}

TEST(SuspectedUnit, OfLabelledScenesIsRight) {
  const auto folder = tests::find_data("mosd/learn");
  if (!folder) GTEST_SKIP() << "mosd/learn is not below CLEAVE_DATA; see the README";

  for (const auto& file : recording::pcd_files(*folder)) {
    const Points metres = evaluation::load_cloud(file).xyz;
    EXPECT_FALSE(is_suspected(metres)) << file;
    EXPECT_FALSE(is_suspected(scattered(metres))) << file;
    EXPECT_TRUE(is_suspected(scaled(metres, 1000))) << file;
    EXPECT_TRUE(is_suspected(scattered(scaled(metres, 1000)))) << file;
  }
}

TEST(MakeMetres, ScalesByTheUnitThatIsGivenAndRefusesWhatNeedsOne) {
  const Points metres = tests::render_touching_boxes().xyz;
  Points xyz = scaled(metres, 1000);

  EXPECT_THROW(make_metres(xyz, std::nullopt, "scan.pcd"), WrongUnit);
  try {
    make_metres(xyz, std::nullopt, "scan.pcd");
  } catch (const WrongUnit& error) {
    EXPECT_NE(std::string(error.what()).find("scan.pcd"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("--unit mm"), std::string::npos);
  }
  EXPECT_NO_THROW(make_metres(xyz, Unit::metre, "scan.pcd"));
  make_metres(xyz, Unit::millimetre, "scan.pcd");
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    if (std::isfinite(metres[i])) {
      EXPECT_NEAR(xyz[i], metres[i], 1e-6);
    }
  }
}

}  // namespace
}  // namespace cleave::recording
