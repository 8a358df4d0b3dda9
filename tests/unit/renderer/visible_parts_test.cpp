// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/visible_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "sensor/renderer/scene/scene.hpp"

namespace cleave::render {
namespace {

// An image of one depth whose pixels of surface 1 and 2 are given.
RayCast flat_image(std::uint32_t width, std::uint32_t height) {
  const std::size_t size = std::size_t{width} * height;
  return {width,
          height,
          std::vector<float>(size, 1),
          std::vector<float>(size, 1),
          std::vector<std::uint16_t>(size, table_surface),
          std::vector<std::uint8_t>(size, 1)};
}

void blank_columns(RayCast& image, std::uint32_t begin, std::uint32_t end) {
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = begin; x < end; ++x) image.measurable[y * image.width + x] = 0;
  }
}

TEST(VisibleParts, AGapOfTwoPixelsDoesNotSplitAPartAndOneOfThreeDoes) {
  RayCast narrow = flat_image(60, 20);
  blank_columns(narrow, 30, 32);
  EXPECT_EQ(label_visible_parts(narrow)[59], 1);
  RayCast wide = flat_image(60, 20);
  blank_columns(wide, 30, 33);
  EXPECT_EQ(label_visible_parts(wide)[0], 1);
  EXPECT_EQ(label_visible_parts(wide)[59], 2);
}

TEST(VisibleParts, AStepInDepthSplitsAPart) {
  RayCast image = flat_image(60, 20);
  for (std::size_t i = 0; i < image.depth_m.size(); ++i) {
    if (i % 60 >= 40) image.depth_m[i] = 1.04F;
  }
  EXPECT_EQ(label_visible_parts(image)[0], 1);
  EXPECT_EQ(label_visible_parts(image)[59], 2);
}

TEST(VisibleParts, PartsOfLessThan120PixelsHaveNoLabel) {
  RayCast image = flat_image(60, 10);
  for (std::size_t i = 0; i < image.surface.size(); ++i) {
    if (i % 60 < 12) image.surface[i] = object_surface(0, outside_part);
    if (i % 60 >= 49) image.surface[i] = object_surface(1, outside_part);
  }
  const std::vector<std::uint16_t> labels = label_visible_parts(image);
  EXPECT_EQ(labels[0], 20);
  EXPECT_EQ(labels[30], 1);
  EXPECT_EQ(labels[59], 0);
}

TEST(VisibleParts, GrazingSurfacesHaveNoLabel) {
  RayCast image = flat_image(30, 30);
  image.cosine.assign(image.cosine.size(), 0.09F);
  EXPECT_EQ(label_visible_parts(image)[0], 0);
}

// Grows each label from one of its pixels, by a rescan of the whole image for each step.
bool is_connected(const RayCast& rays, const std::vector<std::uint16_t>& labels,
                  std::uint16_t label) {
  std::vector<std::int64_t> remaining;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == label) remaining.push_back(static_cast<std::int64_t>(i));
  }
  std::set<std::int64_t> unreached(remaining.begin(), remaining.end());
  std::vector<std::int64_t> reached = {remaining.front()};
  unreached.erase(remaining.front());
  const std::int64_t width = rays.width;
  while (!reached.empty()) {
    const std::int64_t i = reached.back();
    reached.pop_back();
    for (std::int64_t dy = -3; dy <= 3; ++dy) {
      for (std::int64_t dx = -3; dx <= 3; ++dx) {
        if (i % width + dx < 0 || i % width + dx >= width) continue;
        if (unreached.erase(i + dy * width + dx) > 0) reached.push_back(i + dy * width + dx);
      }
    }
  }
  return unreached.empty();
}

TEST(VisibleParts, EachLabelOfARenderedSceneIsConnectedAndOfOneSurface) {
  const Scene scene = make_scene(scene_parameters("crowded", 4));
  const RayCast rays = cast_rays(scene, scene.camera, {});
  const std::vector<std::uint16_t> labels = label_visible_parts(rays);
  std::map<std::uint16_t, std::set<std::uint16_t>> surfaces;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0) continue;
    EXPECT_EQ(rays.measurable[i], 1);
    surfaces[labels[i]].insert(rays.surface[i]);
  }
  EXPECT_GT(surfaces.size(), 12U);
  for (const auto& [label, of_label] : surfaces) {
    ASSERT_EQ(of_label.size(), 1U);
    const std::uint16_t surface = *of_label.begin();
    if (surface == table_surface) {
      EXPECT_TRUE(label >= 1 && label <= 9);
    } else {
      EXPECT_EQ(label / 10, surface);
    }
    EXPECT_TRUE(is_connected(rays, labels, label)) << label;
  }
}

}  // namespace
}  // namespace cleave::render
