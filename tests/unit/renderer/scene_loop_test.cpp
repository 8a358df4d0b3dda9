// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/scene_loop.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "sensor/renderer/depth_sensor.hpp"
#include "sensor/renderer/view/ray_cast.hpp"

namespace cleave::render {
namespace {

// FNV-1a over the values, low byte first.
std::uint64_t hash_of(const std::vector<std::uint16_t>& values) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const std::uint16_t value : values) {
    for (const std::uint64_t byte : {std::uint64_t{value} & 0xFF, std::uint64_t{value} >> 8U}) {
      hash = (hash ^ byte) * 0x100000001B3U;
    }
  }
  return hash;
}

TEST(SceneLoop, RendersTheSameTwiceInAnyOrder) {
  SceneLoop forwards(parse_scene("medium?seed=2&motion=1&frames=3"));
  SceneLoop backwards(parse_scene("medium?seed=2&motion=1&frames=3"));
  const LabelledDepth first = forwards.frame(0);
  const LabelledDepth second = forwards.frame(1);
  EXPECT_EQ(backwards.frame(1).depth_mm, second.depth_mm);
  EXPECT_EQ(backwards.frame(0).depth_mm, first.depth_mm);
  EXPECT_EQ(backwards.frame(0).label, first.label);
  EXPECT_NE(first.depth_mm, second.depth_mm);
}

TEST(SceneLoop, RendersWhatItAlwaysRendered) {
  const LabelledDepth image = SceneLoop(parse_scene("simple?seed=3")).frame(0);
  EXPECT_EQ(hash_of(image.depth_mm), 1747910880579609876U);
  EXPECT_EQ(hash_of(image.label), 2673196309233117720U);
}

TEST(SceneLoop, AStaticScenesFramesDifferInNoiseOnly) {
  SceneLoop loop(parse_scene("simple?seed=3"));
  EXPECT_NE(loop.frame(0).depth_mm, loop.frame(1).depth_mm);
  SceneLoop silent(parse_scene("simple?seed=3&noise=0"));
  EXPECT_EQ(silent.frame(0).depth_mm, silent.frame(1).depth_mm);
}

TEST(SceneLoop, IsMadeOfTheRenderersSteps) {
  SceneLoop loop(parse_scene("simple?seed=3"));
  const Scene scene = make_scene(scene_parameters("simple", 3));
  const DepthSensor sensor(cast_rays(scene, scene.camera, {}));
  SceneLoop silent(parse_scene("simple?seed=3&noise=0"));
  EXPECT_EQ(silent.frame(0).depth_mm, sensor.measure_without_noise().depth_mm);
}

TEST(SceneLoop, ShowsACameraOfOtherResolutionTheSameScene) {
  const SceneRequest request = parse_scene("simple?seed=3&noise=0");
  const LabelledDepth usual = SceneLoop(request).frame(0);
  const LabelledDepth large = SceneLoop(request, scaled({}, 2)).frame(0);
  ASSERT_EQ(large.width, 2 * usual.width);
  ASSERT_EQ(large.height, 2 * usual.height);

  std::size_t compared = 0;
  std::size_t alike = 0;
  for (std::size_t y = 0; y < usual.height; ++y) {
    for (std::size_t x = 0; x < usual.width; ++x) {
      const int depth_mm = usual.depth_mm[y * usual.width + x];
      if (depth_mm == 0) continue;
      const int close_mm = large.depth_mm[2 * y * large.width + 2 * x];
      ++compared;
      alike += std::abs(depth_mm - close_mm) < 5 ? 1 : 0;
    }
  }
  EXPECT_GT(static_cast<double>(alike), 0.97 * static_cast<double>(compared));
}

}  // namespace
}  // namespace cleave::render
