// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/convex_components.hpp"

#include <gtest/gtest.h>

namespace cleave::segmentation {
namespace {

std::vector<std::uint32_t> components(std::uint32_t supervoxels,
                                      const std::vector<SupervoxelEdge>& edges) {
  std::vector<std::uint32_t> segment;
  ConvexComponents().find(supervoxels, edges, {}, segment);
  return segment;
}

TEST(ConvexComponents, AreConnectedByValidEdgesThatAreConvexOrNearlyFlat) {
  // 0 - 1 flat, 1 - 2 bends by 18 degrees, 2 - 3 by 26, 3 - 4 a convex edge, 4 - 5 not valid.
  const std::vector<SupervoxelEdge> edges = {
      {.first = 0, .second = 1, .cosine = 1, .valid = true},
      {.first = 1, .second = 2, .cosine = 0.95F, .valid = true},
      {.first = 2, .second = 3, .cosine = 0.9F, .valid = true},
      {.first = 3, .second = 4, .cosine = 0, .convex = true, .valid = true},
      {.first = 4, .second = 5, .cosine = 1, .valid = false}};

  EXPECT_EQ(components(6, edges), (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 2}));
}

TEST(ConvexComponents, AreJoinedByASingleWeakEdge) {
  const std::vector<SupervoxelEdge> edges = {
      {.first = 0, .second = 1, .cosine = 0.1F, .valid = true},
      {.first = 0, .second = 2, .cosine = 0.95F, .valid = true},
      {.first = 1, .second = 2, .cosine = 0.95F, .valid = true}};

  EXPECT_EQ(components(3, edges), (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST(ConvexComponents, AreEachASupervoxelWithoutEdgesAndNoneWithoutSupervoxels) {
  EXPECT_EQ(components(2, {}), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(components(0, {}), std::vector<std::uint32_t>{});
}

}  // namespace
}  // namespace cleave::segmentation
