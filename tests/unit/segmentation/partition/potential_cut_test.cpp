// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/potential_cut.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace cleave::segmentation {
namespace {

std::vector<CutEdge> random_edges(std::uint32_t vertices, std::mt19937& random) {
  std::uniform_real_distribution<float> weight(0.05F, 1);
  std::vector<CutEdge> edges;
  for (std::uint32_t v = 1; v < vertices; ++v) {
    edges.push_back({v - 1, v, weight(random)});
    if (v > 4) edges.push_back({v, static_cast<std::uint32_t>(random() % (v - 1)), weight(random)});
  }
  return edges;
}

// Equations 4.17 to 4.19, summed up anew.
double utility(std::span<const CutEdge> edges, const Eigen::VectorXd& vector,
               const std::set<std::uint32_t>& side) {
  double weight = 0;
  double potential = 0;
  const double range = vector.maxCoeff() - vector.minCoeff();
  for (const CutEdge& edge : edges) {
    if (side.contains(edge.first) == side.contains(edge.second)) continue;
    weight += edge.weight;
    potential += std::abs(vector[edge.first] - vector[edge.second]) / range;
  }
  return potential / weight;
}

class PotentialCut : public testing::TestWithParam<std::uint32_t> {};

TEST_P(PotentialCut, IsTheBestOfAllCutsAlongAllEigenvectors) {
  const std::size_t least_vertices = GetParam();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    constexpr std::uint32_t vertices = 40;
    const auto edges = random_edges(vertices, random);
    SubgraphStore store;
    std::vector<Subgraph> parts;
    store.reset(vertices, edges, parts);
    ASSERT_EQ(parts.size(), 1U);
    const Eigen::MatrixXd vectors =
        Eigen::MatrixXd::NullaryExpr(vertices, 4, [&] { return value(random); });
    store.sort_along(vectors, parts[0]);
    PotentialCutFinder finder;
    finder.set_least_vertices(GetParam());
    finder.decomposed(store, parts[0], vectors);

    const Cut cut = finder.find(store, parts[0]);

    double best = 0;
    for (std::size_t k = 0; k < store.orders(); ++k) {
      const auto order = store.order(k, parts[0]);
      for (std::size_t position = least_vertices; position + least_vertices <= order.size();
           ++position) {
        const std::set<std::uint32_t> side(order.begin(),
                                           order.begin() + static_cast<std::ptrdiff_t>(position));
        best = std::max(best, utility(edges, vectors.col(static_cast<Eigen::Index>(k)), side));
      }
    }
    EXPECT_NEAR(cut.utility, best, 1e-9);
    EXPECT_GE(cut.position, least_vertices);
    EXPECT_LE(cut.position + least_vertices, vertices);
  }
}

INSTANTIATE_TEST_SUITE_P(SmallestSides, PotentialCut, testing::Values(1, 7));

TEST(Equation4_19, IsThePotentialOfACutByItsWeight) {
  // 0 -- 1 -- 2 -- 3; scaled to [0, 1] the vector is 0, 0.25, 0.75, 1.
  const std::vector<CutEdge> edges = {{0, 1, 1}, {1, 2, 0.1F}, {2, 3, 1}};
  SubgraphStore store;
  std::vector<Subgraph> parts;
  store.reset(4, edges, parts);
  const Eigen::Vector4d vector(-2, -1, 1, 2);
  store.sort_along(vector, parts[0]);
  PotentialCutFinder finder;
  finder.decomposed(store, parts[0], vector);

  const Cut cut = finder.find(store, parts[0]);

  EXPECT_EQ(cut.position, 2U);
  EXPECT_NEAR(cut.utility, 0.5 / 0.1, 1e-6);
}

TEST(PotentialCutFinder, DoesNotCutAGraphTooSmallForTwoSides) {
  PotentialCutFinder finder;
  finder.set_least_vertices(30);

  EXPECT_FALSE(finder.may_cut({}, {.vertex_begin = 0, .vertex_end = 59}));
  EXPECT_TRUE(finder.may_cut({}, {.vertex_begin = 0, .vertex_end = 60}));
}

}  // namespace
}  // namespace cleave::segmentation
