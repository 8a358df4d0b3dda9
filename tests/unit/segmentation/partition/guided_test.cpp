// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/guided.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace cleave::segmentation {
namespace {

// A chain of four vertices of ten points: 0 = 1 - 2 = 3, cannot-link in the middle.
struct Chain {
  std::vector<CutEdge> edges = {{0, 1, 1}, {1, 2, 0.5F, 1, 0.5F}, {2, 3, 1}};
  SubgraphStore store;
  std::vector<Subgraph> parts;
  std::vector<std::uint32_t> points = {10, 10, 10, 10};

  // The first eigenvector isolates vertex 0 and then 2; only the second splits in the middle.
  Chain() {
    store.reset(4, edges, parts);
    Eigen::MatrixXd vectors(4, 2);
    vectors << 0, 0, 2, 1, 1, 2, 3, 3;
    store.sort_along(vectors, parts[0]);
  }
};

TEST(GuidedCut, IsAlongTheFirstEigenvectorThatAgreesWithTheTruth) {
  Chain chain;
  const std::vector<std::uint32_t> object = {1, 1, 2, 2};
  GuidedCutFinder finder;
  finder.start(object, chain.points);

  const Cut cut = finder.find(chain.store, chain.parts[0]);

  EXPECT_EQ(cut.order, 1U);
  EXPECT_EQ(cut.position, 2U);
  ASSERT_EQ(finder.cuts().size(), 1U);
  EXPECT_EQ(finder.cuts()[0].eigenvector, 2U);
  EXPECT_DOUBLE_EQ(finder.cuts()[0].utility, 2);
}

TEST(GuidedCut, NeitherSplitsAnObjectNorCutsOffNothing) {
  Chain chain;
  for (const std::vector<std::uint32_t>& object :
       {std::vector<std::uint32_t>{1, 1, 1, 1}, {1, 1, 1, 2}, {0, 0, 1, 1}, {0, 0, 0, 0}}) {
    GuidedCutFinder finder;
    finder.start(object, chain.points);

    EXPECT_EQ(finder.find(chain.store, chain.parts[0]).utility, 0);
    EXPECT_TRUE(finder.cuts().empty());
  }
}

// An image of a floor, object 2, and a wall, object 700000, that meet in a concave crease of 90
// degrees, halfway down the image.
struct FloorAndWall {
  static constexpr std::uint32_t width = 160, height = 120;
  std::vector<float> xyz;
  std::vector<std::uint32_t> truth;

  FloorAndWall() {
    for (std::uint32_t row = 0; row < height; ++row) {
      for (std::uint32_t column = 0; column < width; ++column) {
        const float u = (static_cast<float>(column) - 79.5F) / 525;
        const float v = (static_cast<float>(row) - 59.5F) / 525;
        const float z = 1 / (0.8F + 0.8F * std::abs(v));
        xyz.insert(xyz.end(), {u * z, v * z, z});
        truth.push_back(v > 0 ? 2 : 700000);
      }
    }
  }
  [[nodiscard]] CloudView view() const { return {xyz.data(), 3, width, height}; }
};

class Guided : public testing::TestWithParam<Representation> {};

TEST_P(Guided, CutsTheFloorFromTheWallOnce) {
  const FloorAndWall scene;
  Options options;
  options.representation = GetParam();

  const GuidedSegmentation result = segment_guided(scene.view(), scene.truth, options);

  EXPECT_EQ(result.objects, 2U);
  ASSERT_EQ(result.cuts.size(), 1U);
  EXPECT_LE(result.cuts[0].eigenvector, 3U);
  EXPECT_GT(result.cuts[0].utility, options.partition.utility_threshold);
}

TEST_P(Guided, CutsNothingInASceneOfOneObject) {
  const FloorAndWall scene;
  Options options;
  options.representation = GetParam();

  const auto result =
      segment_guided(scene.view(), std::vector<std::uint32_t>(scene.view().size(), 9), options);

  EXPECT_EQ(result.objects, 1U);
  EXPECT_TRUE(result.cuts.empty());
}

INSTANTIATE_TEST_SUITE_P(BothRepresentations, Guided,
                         testing::Values(Representation::cells, Representation::voxels));

TEST(GuidedSegmentation, RefusesLabelsOfAnotherSizeAndWrongOptions) {
  const FloorAndWall scene;
  Options wrong;
  wrong.voxel.size_m = -1;

  EXPECT_THROW((void)segment_guided(scene.view(), std::vector<std::uint32_t>(3), {}),
               std::invalid_argument);
  EXPECT_THROW((void)segment_guided(scene.view(), scene.truth, wrong), std::invalid_argument);
}

TEST(GuidedSegmentation, FindsNothingWhereNothingWasMeasured) {
  const GuidedSegmentation result = segment_guided({}, {}, {});

  EXPECT_TRUE(result.cuts.empty());
  EXPECT_EQ(result.objects, 0U);
}

}  // namespace
}  // namespace cleave::segmentation
