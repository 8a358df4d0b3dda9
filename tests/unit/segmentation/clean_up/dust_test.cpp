// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "segmentation/clean_up/dust_settler.hpp"
#include "segmentation/math/no_index.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"
#include "tests/unit/segmentation/support/table_cloud.hpp"

namespace cleave::segmentation {
namespace {

using Segments = std::vector<std::uint32_t>;
constexpr std::uint32_t dropped = no_index;

// Supervoxels are segments here; each has a run of so many points.
Segments settle(const std::vector<std::uint32_t>& points, const std::vector<SupervoxelEdge>& edges,
                std::uint32_t min_points) {
  std::vector<PointRun> runs;
  Segments segment_of_supervoxel;
  for (std::uint32_t s = 0; s < points.size(); ++s) {
    segment_of_supervoxel.push_back(s);
    if (points[s] > 0) runs.push_back({.segment = s, .begin = 0, .end = points[s]});
  }
  Segments settled;
  DustSettler().settle(runs, edges, segment_of_supervoxel,
                       static_cast<std::uint32_t>(points.size()), min_points, settled);
  return settled;
}

SupervoxelEdge contact(std::uint32_t first, std::uint32_t second) {
  return {.first = first, .second = second, .touching_voxels = 1, .valid = false};
}

TEST(DustSettler, LetsASliverJoinWhatItTouches) {
  EXPECT_EQ(settle({500, 7, 300}, {contact(0, 1)}, 100), (Segments{0, 0, 2}));
}

TEST(DustSettler, DropsAnIsland) {
  EXPECT_EQ(settle({500, 7, 300}, {contact(0, 2)}, 100), (Segments{0, dropped, 2}));
}

TEST(DustSettler, DropsWhatIsTooSmallEvenTogetherAndKeepsWhatIsLargeEnough) {
  EXPECT_EQ(settle({500, 30, 40, 60, 50}, {contact(1, 2), contact(3, 4)}, 100),
            (Segments{0, dropped, dropped, 3, 3}));
}

TEST(DustSettler, DoesNotLetASliverJoinASegmentWithoutPoints) {
  EXPECT_EQ(settle({500, 0, 7}, {contact(0, 1), contact(1, 2)}, 100),
            (Segments{0, dropped, dropped}));
}

TEST(DustSettler, IsSwitchedOffByZero) {
  EXPECT_EQ(settle({5, 0, 1}, {contact(0, 2)}, 0), (Segments{0, 1, 2}));
}

void expect_no_dust(const Segmented& result, std::uint32_t min_points) {
  std::vector<std::uint32_t> counted(result.segmentation.segments.size() + 1);
  for (const std::uint16_t label : result.labels) {
    ASSERT_LT(label, counted.size());
    ++counted[label];
  }
  for (const Segment& s : result.segmentation.segments) {
    EXPECT_EQ(s.point_count, counted[s.label]);
    EXPECT_GE(s.point_count, min_points);
  }
  for (const Border& border : result.segmentation.borders) {
    EXPECT_LT(border.second, counted.size());
    EXPECT_GT(border.first, 0);
  }
}

class Dust : public testing::TestWithParam<Representation> {};

TEST_P(Dust, IsNoSegmentInNoisyScenes) {
  for (const std::uint32_t min_points : {145U, 3000U}) {
    Options options;
    options.representation = GetParam();
    options.clean_up.min_segment_points = min_points;
    for (unsigned seed = 0; seed < 6; ++seed) {
      DepthScene scene(seed);
      std::mt19937 random(seed);
      for (int flying = 0; flying < 300; ++flying) {  // pixels that float before the scene
        float* p = &scene.xyz[3 * (random() % scene.view().size())];
        for (int axis = 0; axis < 3; ++axis) p[axis] *= 0.7F;
      }
      const Segmented result = segmented(scene.view(), options);

      EXPECT_FALSE(result.segmentation.segments.empty());
      expect_no_dust(result, min_points);
    }
  }
}

TEST_P(Dust, IsAllThatASceneConsistsOfIfMoreIsAskedForThanItHas) {
  Options options;
  options.representation = GetParam();
  options.clean_up.min_segment_points = 1000000;

  const Segmented result = segmented(DepthScene(1).view(), options);

  EXPECT_EQ(result.labels, std::vector<std::uint16_t>(result.labels.size(), 0));
  EXPECT_TRUE(result.segmentation.segments.empty());
  EXPECT_TRUE(result.segmentation.borders.empty());
  EXPECT_GT(result.segmentation.measured_points, 0U);
}

INSTANTIATE_TEST_SUITE_P(OnBothPaths, Dust,
                         testing::Values(Representation::cells, Representation::voxels));

TEST(Dust, OfAnUnorganisedCloudIsAsSmallAsWasAskedForExactly) {
  Options options;
  options.voxel.viewpoint = Viewpoint::multiple;
  options.clean_up.min_segment_points = 700;
  TableCloud table(0.01F);
  for (int i = 0; i < 100; ++i) {
    table.xyz.insert(table.xyz.end(), {0.5F + 0.1F * static_cast<float>(i % 10),
                                       0.1F * static_cast<float>(i / 10), 2.5F});
  }

  expect_no_dust(segmented(table.view(), options), 700);
}

TEST(Dust, DoesNotReachLabelsOnceCleanUpIsOff) {
  const std::vector<float> xyz = {0, 0, 1, 5, 0, 1, 0, 5, 1};
  Options options;
  options.clean_up.min_segment_points = 0;

  EXPECT_EQ(segmented({xyz.data(), 3, 3, 1}, options).labels,
            (std::vector<std::uint16_t>{1, 2, 3}));
}

}  // namespace
}  // namespace cleave::segmentation
