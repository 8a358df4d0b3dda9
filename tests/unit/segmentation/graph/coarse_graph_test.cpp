// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/coarse_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace cleave::segmentation {
namespace {

std::vector<SupervoxelEdge> random_supervoxel_graph(std::uint32_t vertices, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<SupervoxelEdge> edges;
  for (std::uint32_t a = 0; a < vertices; ++a) {
    for (std::uint32_t b = a + 1; b < std::min(a + 6, vertices); ++b) {
      SupervoxelEdge edge{.first = a, .second = b};
      edge.weight = uniform(random);
      edge.cosine = 1 - uniform(random) * 0.05F;
      edge.valid = uniform(random) > 0.1F;
      edge.cannot_link_share = std::floor(std::max(uniform(random) - 0.5F, 0.0F) * 128) / 64;
      edges.push_back(edge);
    }
  }
  return edges;
}

TEST(GraphCoarsener, KeepsEveryCutOfTheCoarseGraph) {
  const auto edges = random_supervoxel_graph(200, 1);
  GraphCoarsener coarsener;

  const std::uint32_t vertices = coarsener.coarsen(200, edges, 2);

  EXPECT_LT(vertices, 150U);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<float, float>> expected;
  for (const SupervoxelEdge& edge : edges) {
    const auto [low, high] = std::minmax(coarsener.vertex_of_supervoxel()[edge.first],
                                         coarsener.vertex_of_supervoxel()[edge.second]);
    if (!edge.valid || low == high) continue;
    auto& sum = expected[{low, high}];
    sum.first += edge.weight;
    sum.second += edge.cannot_link_share;
  }
  ASSERT_EQ(coarsener.edges().size(), expected.size());
  auto next = expected.begin();
  for (const CutEdge& edge : coarsener.edges()) {
    EXPECT_EQ(std::make_pair(edge.first, edge.second), next->first);
    EXPECT_FLOAT_EQ(edge.weight, next->second.first);
    EXPECT_EQ(edge.cannot_links, next->second.second);
    ++next;
  }
}

TEST(GraphCoarsener, JoinsAtMostTwoInARoundAndOnlySmoothNeighbours) {
  const auto edges = random_supervoxel_graph(200, 2);
  GraphCoarsener coarsener;

  const std::uint32_t vertices = coarsener.coarsen(200, edges, 1);

  std::vector<std::vector<std::uint32_t>> members(vertices);
  for (std::uint32_t s = 0; s < 200; ++s) {
    members[coarsener.vertex_of_supervoxel()[s]].push_back(s);
  }
  for (const auto& of : members) {
    ASSERT_GE(of.size(), 1U);
    ASSERT_LE(of.size(), 2U);
    if (of.size() == 1) continue;
    const auto edge = std::find_if(edges.begin(), edges.end(), [&](const SupervoxelEdge& e) {
      return e.first == of[0] && e.second == of[1];
    });
    ASSERT_NE(edge, edges.end());
    EXPECT_TRUE(edge->valid && !edge->is_cannot_link() && edge->cosine > 0.984F);
  }
}

TEST(GraphCoarsener, LeavesTheGraphAsItIsWithoutRounds) {
  const auto edges = random_supervoxel_graph(50, 3);
  GraphCoarsener coarsener;

  EXPECT_EQ(coarsener.coarsen(50, edges, 0), 50U);
  for (std::uint32_t s = 0; s < 50; ++s) EXPECT_EQ(coarsener.vertex_of_supervoxel()[s], s);
}

}  // namespace
}  // namespace cleave::segmentation
