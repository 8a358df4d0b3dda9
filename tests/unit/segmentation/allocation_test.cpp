#include <gtest/gtest.h>

#include <memory>

#include "allocation_counter.hpp"
#include "depth_scene.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::segmentation {
namespace {

TEST(AllocationCounter, SeesAllocations) {
  const std::uint64_t before = allocations();
  const auto one = std::make_unique<std::vector<int>>(100);

  EXPECT_EQ(allocations(), before + 2);
}

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
  const std::uint64_t before = allocations();

  segment_all();

  EXPECT_EQ(allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(BothRepresentations, AllocationsOf,
                         testing::Values(Representation::cells, Representation::voxels));

}  // namespace
}  // namespace cleave::segmentation
