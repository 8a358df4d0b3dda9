// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "segmentation/partition/graph_partition.hpp"

namespace cleave::segmentation {
namespace {

// `rows` times `count` sheets of `side` x `side` supervoxels each; where two meet is a cannot-link
// crease.
std::vector<SupervoxelEdge> sheets(std::uint32_t count, std::uint32_t side,
                                   std::uint32_t rows = 1) {
  std::vector<SupervoxelEdge> edges;
  const std::uint32_t width = count * side;
  const auto join = [&](std::uint32_t v, std::uint32_t u, bool crease) {
    edges.push_back({.first = v,
                     .second = u,
                     .touching_voxels = 1,
                     .weight = crease ? 0.05F : 1,
                     .cosine = crease ? 0.0F : 1.0F,
                     .valid = true,
                     .cannot_link_share = crease ? 1.0F : 0.0F});
  };
  for (std::uint32_t row = 0; row < rows * side; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const std::uint32_t v = row * width + column;
      if (column + 1 < width) join(v, v + 1, (column + 1) % side == 0);
      if (row + 1 < rows * side) join(v, v + width, (row + 1) % side == 0);
    }
  }
  return edges;
}

std::uint32_t partition(const std::vector<SupervoxelEdge>& edges, std::uint32_t supervoxels,
                        const Options& options, std::vector<std::uint32_t>& segment) {
  return GraphPartitioner().partition(supervoxels, edges, options, segment);
}

class ConstrainedSsc : public testing::TestWithParam<float> {};

TEST_P(ConstrainedSsc, CutsSheetsApartAtTheirCreases) {
  Options options;
  options.algorithm = Algorithm::constrained_ssc;
  options.partition.cannot_link_weight = GetParam();
  for (const std::uint32_t rounds : {0U, 2U}) {
    options.partition.coarsening_rounds = rounds;
    for (const std::uint32_t side : {3U, 8U, 15U}) {
      std::vector<std::uint32_t> segment;

      EXPECT_EQ(partition(sheets(5, side), 5 * side * side, options, segment), 5U) << side;

      for (std::uint32_t v = 0; v < segment.size(); ++v) {
        EXPECT_EQ(segment[v], segment[v % (5 * side) / side * side]) << v;
      }
    }
  }
}

// At 0 the signed ratio cut is the ratio cut.
INSTANTIATE_TEST_SUITE_P(WeightOfCannotLinks, ConstrainedSsc, testing::Values(0.0F, 0.5F, 1.0F));

// The smallest eigenvector of a wide field of sheets changes along it and not across it.
TEST(SingleDecomposition, HasOnlyTheEigenvectorsOfTheWhole) {
  const std::uint32_t side = 5;
  const auto field = sheets(6, side, 2);
  Options options;
  options.partition.coarsening_rounds = 0;
  options.partition.eigenvectors = 1;
  const auto segments = [&](Decomposition decomposition, std::uint32_t eigenvectors) {
    options.partition.decomposition = decomposition;
    options.partition.eigenvectors = eigenvectors;
    std::vector<std::uint32_t> segment;
    return partition(field, 12 * side * side, options, segment);
  };

  EXPECT_EQ(segments(Decomposition::single, 1), 6U);
  EXPECT_EQ(segments(Decomposition::recursive, 1), 12U);
  EXPECT_EQ(segments(Decomposition::single, 10), 12U);
}

class PartitionWith : public testing::TestWithParam<Laplacian> {};

TEST_P(PartitionWith, EveryLaplacianCutsSheetsApart) {
  for (const Algorithm algorithm : {Algorithm::ssc, Algorithm::constrained_ssc}) {
    Options options;
    options.algorithm = algorithm;
    options.partition.laplacian = GetParam();
    std::vector<std::uint32_t> segment;

    EXPECT_EQ(partition(sheets(4, 9), 4 * 81, options, segment), 4U);
  }
}

INSTANTIATE_TEST_SUITE_P(Equations2_11To2_14, PartitionWith,
                         testing::Values(Laplacian::unnormalised, Laplacian::symmetric,
                                         Laplacian::random_walk));

}  // namespace
}  // namespace cleave::segmentation
