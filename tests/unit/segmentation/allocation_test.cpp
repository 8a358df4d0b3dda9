#include <gtest/gtest.h>

#include "cleave/bench/allocation_counter.hpp"
#include "depth_scene.hpp"
#include "segmentation/segmenter.hpp"
#include "table_cloud.hpp"

namespace cleave::segmentation {
namespace {

class AllocationsOf : public testing::TestWithParam<Representation> {};

TEST_P(AllocationsOf, AWarmSegmenterAreNone) {
  Options options;
  options.representation = GetParam();
  Segmenter segmenter(options);
  Segmentation result;
  std::vector<DepthScene> scenes;
  for (unsigned seed = 0; seed < 6; ++seed) scenes.emplace_back(seed);
  std::vector<std::uint16_t> labels(scenes.front().view().size());
  const auto segment_all = [&] {
    for (const DepthScene& scene : scenes) {
      ASSERT_EQ(segmenter.segment(scene.view(), labels, result), Outcome::segmented);
    }
  };
  segment_all();
  const auto before = client::allocations_of_this_thread();

  segment_all();

  EXPECT_EQ(client::allocations_of_this_thread(), before);
}

TEST_P(AllocationsOf, AWarmSegmenterAreNoneForSparseClouds) {
  Options options;
  options.representation = GetParam();
  options.voxel.viewpoint = Viewpoint::multiple;
  Segmenter segmenter(options);
  Segmentation result;
  std::vector<TableCloud> tables;
  for (const float spacing : {0.01F, 0.02F, 0.5F}) tables.emplace_back(spacing);
  std::vector<std::uint16_t> labels(tables.front().view().size());
  const auto segment_all = [&] {
    for (const TableCloud& table : tables) {
      ASSERT_EQ(segmenter.segment(table.view(), labels, result), Outcome::segmented);
    }
  };
  segment_all();
  const auto before = client::allocations_of_this_thread();

  segment_all();

  EXPECT_EQ(client::allocations_of_this_thread(), before);
}

INSTANTIATE_TEST_SUITE_P(BothRepresentations, AllocationsOf,
                         testing::Values(Representation::cells, Representation::voxels));

}  // namespace
}  // namespace cleave::segmentation
