// SPDX-License-Identifier: BSD-3-Clause
// What holds for every algorithm, on a small scene of two boxes on a table.
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"

namespace cleave::segmentation {
namespace {

class EveryAlgorithm : public testing::TestWithParam<Algorithm> {};

TEST_P(EveryAlgorithm, LabelsEveryMeasuredPointAndTellsTheBoxFromTheTable) {
  const DepthScene scene(3);
  Options options;
  options.algorithm = GetParam();
  Segmenter segmenter(options);

  const auto labels = segmented(segmenter, scene.view()).labels;

  const auto at = [&](std::uint32_t row, std::uint32_t column) {
    std::uint32_t pixel = row * scene.width + column;
    while (labels[pixel] == 0) ++pixel;
    return labels[pixel];
  };
  EXPECT_EQ(at(20, 20), at(100, 140)) << "one table";
  EXPECT_NE(at(67, 65), at(95, 65)) << "the box stands on it";
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(labels[i] != 0, std::isfinite(scene.xyz[3 * i + 2])) << i;
  }
}

TEST_P(EveryAlgorithm, GivesTheSameLabelsWhateverItSawBefore) {
  Options options;
  options.algorithm = GetParam();
  Segmenter fresh(options);
  Segmenter used(options);
  for (unsigned seed = 0; seed < 3; ++seed) (void)segmented(used, DepthScene(seed).view()).labels;

  EXPECT_EQ(segmented(fresh, DepthScene(5).view()).labels,
            segmented(used, DepthScene(5).view()).labels);
}

TEST_P(EveryAlgorithm, SegmentsALonePoint) {
  Options options;
  options.algorithm = GetParam();
  const std::vector<float> xyz = {0.1F, 0.1F, 1};
  std::vector<std::uint16_t> labels(1);
  Segmentation result;

  EXPECT_EQ(Segmenter(options).segment({xyz.data(), 3, 1, 1}, labels, result), Outcome::segmented);
  EXPECT_EQ(labels[0], 1);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EveryAlgorithm,
                         testing::Values(Algorithm::ssc, Algorithm::constrained_ssc, Algorithm::svc,
                                         Algorithm::convex_components));

}  // namespace
}  // namespace cleave::segmentation
