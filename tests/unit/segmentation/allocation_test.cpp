// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "segmentation/segmenter.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/table_cloud.hpp"
#include "tests/unit/segmentation/view/stored_scene.hpp"
#include "workbench/bench/allocation_counter.hpp"

namespace cleave::segmentation {
namespace {

class AllocationsOf : public testing::TestWithParam<Representation> {
 protected:
  template <class Clouds>
  static void expect_none(const Clouds& clouds, Viewpoint viewpoint = Viewpoint::automatic) {
    Options options;
    options.representation = GetParam();
    options.voxel.viewpoint = viewpoint;
    Segmenter segmenter(options);
    Segmentation result;
    std::vector<std::uint16_t> labels(clouds.front().view().size());
    const auto segment_all = [&] {
      for (const auto& cloud : clouds) {
        ASSERT_EQ(segmenter.segment(cloud.view(), labels, result), Outcome::segmented);
      }
    };
    segment_all();
    const auto before = workbench::allocations_of_this_thread();

    segment_all();

    EXPECT_EQ(workbench::allocations_of_this_thread(), before);
  }
};

TEST_P(AllocationsOf, AWarmSegmenterAreNone) {
  std::vector<DepthScene> scenes;
  for (unsigned seed = 0; seed < 6; ++seed) scenes.emplace_back(seed);

  expect_none(scenes);
}

TEST_P(AllocationsOf, AWarmSegmenterAreNoneForSparseClouds) {
  std::vector<TableCloud> tables;
  for (const float spacing : {0.01F, 0.02F, 0.5F}) tables.emplace_back(spacing);

  expect_none(tables);
  expect_none(tables, Viewpoint::multiple);
}

TEST_P(AllocationsOf, AWarmSegmenterAreNoneForImagesInAnyFrameAndOrder) {
  expect_none(scenes_on_a_robot());
}

INSTANTIATE_TEST_SUITE_P(BothRepresentations, AllocationsOf,
                         testing::Values(Representation::cells, Representation::voxels));

}  // namespace
}  // namespace cleave::segmentation
