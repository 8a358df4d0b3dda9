// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/best_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace cleave::segmentation {
namespace {

std::vector<CutEdge> random_edges(std::uint32_t vertices, std::mt19937& random) {
  std::uniform_real_distribution<float> weight(0.05F, 1);
  // One in five counts, in part.
  const auto share = [](std::mt19937& r) {
    return std::max(static_cast<float>(r() % 320) / 64 - 4, 0.0F);
  };
  std::vector<CutEdge> edges;
  for (std::uint32_t v = 1; v < vertices; ++v) {
    edges.push_back({v - 1, v, weight(random), share(random)});
    if (v > 4)
      edges.push_back(
          {v, static_cast<std::uint32_t>(random() % (v - 1)), weight(random), share(random)});
  }
  return edges;
}

// Equation 4.8, summed up anew.
double utility(std::span<const CutEdge> edges, const std::set<std::uint32_t>& side) {
  double weight = 0;
  double cannot_links = 0;
  for (const CutEdge& edge : edges) {
    if (side.contains(edge.first) == side.contains(edge.second)) continue;
    weight += edge.weight;
    cannot_links += edge.cannot_links;
  }
  return cannot_links == 0 ? 0 : cannot_links / weight;
}

TEST(BestCut, IsTheBestOfAllCutsAlongAllEigenvectors) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    constexpr std::uint32_t vertices = 40;
    const auto edges = random_edges(vertices, random);
    SubgraphStore store;
    std::vector<Subgraph> parts;
    store.reset(vertices, edges, parts);
    ASSERT_EQ(parts.size(), 1U);
    store.sort_along(Eigen::MatrixXd::Random(vertices, 4), parts[0]);

    const Cut cut = BestCutFinder().find(store, parts[0]);

    double best = 0;
    for (std::size_t k = 0; k < store.orders(); ++k) {
      const auto order = store.order(k, parts[0]);
      for (std::size_t position = 1; position < order.size(); ++position) {
        const std::set<std::uint32_t> side(order.begin(),
                                           order.begin() + static_cast<std::ptrdiff_t>(position));
        best = std::max(best, utility(edges, side));
      }
    }
    EXPECT_NEAR(cut.utility, best, 1e-9);
    const auto chosen = store.order(cut.order, parts[0]).first(cut.position);
    EXPECT_NEAR(utility(edges, {chosen.begin(), chosen.end()}), best, 1e-9);
  }
}

TEST(Equation4_8, IsTheCutCannotLinksPerCutWeight) {
  // 0 -- 1 == 2 -- 3 with two cannot-link edges of weight 0.1 and 0.3 in the middle.
  const std::vector<CutEdge> edges = {
      {0, 1, 1, false}, {1, 2, 0.1F, true}, {0, 2, 0.3F, true}, {2, 3, 1, false}};
  SubgraphStore store;
  std::vector<Subgraph> parts;
  store.reset(4, edges, parts);
  store.sort_along(Eigen::Vector4d(-2, -1, 1, 2), parts[0]);

  const Cut cut = BestCutFinder().find(store, parts[0]);

  EXPECT_EQ(cut.position, 2U);
  EXPECT_NEAR(cut.utility, 2 / 0.4, 1e-6);
}

TEST(SubgraphStore, SplitsIntoConnectedPartsThatInheritTheirOrders) {
  // A path 0 1 2 3 4 cut around its middle leaves three parts.
  const std::vector<CutEdge> edges = {
      {0, 1, 1, false}, {1, 2, 1, true}, {2, 3, 1, true}, {3, 4, 1, false}};
  SubgraphStore store;
  std::vector<Subgraph> whole, parts;
  store.reset(5, edges, whole);
  Eigen::MatrixXd vector(5, 1);
  vector << 5, 4, 3, 2, 1;
  store.sort_along(vector, whole[0]);

  store.split(whole[0], std::vector<std::uint32_t>{2}, parts);

  const auto as_vector = [](auto span) { return std::vector(span.begin(), span.end()); };
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(as_vector(store.vertices(parts[0])), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(as_vector(store.order(0, parts[0])), (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(as_vector(store.vertices(parts[2])), (std::vector<std::uint32_t>{3, 4}));
  EXPECT_EQ(store.edges(parts[2]).size(), 1U);
  EXPECT_EQ(store.cannot_links(parts[2]), 0);
}

}  // namespace
}  // namespace cleave::segmentation
