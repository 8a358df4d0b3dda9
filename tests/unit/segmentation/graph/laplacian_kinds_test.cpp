// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numeric>
#include <random>

#include "segmentation/partition/eigenvectors.hpp"

namespace cleave::segmentation {
namespace {

// A ring with chords, of which some weigh less than nothing if asked for.
std::vector<WeightedEdge> random_graph(std::uint32_t vertices, bool is_signed) {
  std::mt19937 random(vertices);
  std::uniform_real_distribution<double> weight(0.05, 1);
  std::vector<WeightedEdge> edges;
  const auto add = [&](std::uint32_t v, std::uint32_t u) {
    edges.push_back({v, u, is_signed && random() % 6 == 0 ? -1 : weight(random)});
  };
  for (std::uint32_t v = 0; v < vertices; ++v) {
    add(v, (v + 1) % vertices);
    if (v + 7 < vertices) add(v, v + 7);
  }
  return edges;
}

Eigen::MatrixXd eigenvectors(std::uint32_t vertices, const std::vector<WeightedEdge>& edges,
                             std::uint32_t wanted, LaplacianKind kind) {
  std::vector<std::uint32_t> all(vertices);
  std::iota(all.begin(), all.end(), 0U);
  LaplacianEigensolver solver;
  solver.reset(vertices, edges);
  return solver.solve(all, edges, wanted, kind);
}

// Equations 4.9 and 4.14, of which 2.11 is the case without negative weights.
struct Oracle {
  Eigen::MatrixXd laplacian;
  Eigen::VectorXd degree;

  Oracle(std::uint32_t vertices, const std::vector<WeightedEdge>& edges)
      : laplacian(Eigen::MatrixXd::Zero(vertices, vertices)) {
    for (const WeightedEdge& edge : edges) {
      laplacian(edge.first, edge.first) += std::abs(edge.weight);
      laplacian(edge.second, edge.second) += std::abs(edge.weight);
      laplacian(edge.first, edge.second) -= edge.weight;
      laplacian(edge.second, edge.first) -= edge.weight;
    }
    degree = laplacian.diagonal();
  }

  // Unit eigenvectors, ascending.
  [[nodiscard]] Eigen::MatrixXd vectors(Laplacian normalisation) const {
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
    if (normalisation == Laplacian::unnormalised) return Solver(laplacian).eigenvectors();
    const Eigen::MatrixXd scale = degree.cwiseSqrt().cwiseInverse().asDiagonal();
    const Solver symmetric(scale * laplacian * scale);
    if (normalisation == Laplacian::symmetric) return symmetric.eigenvectors();
    return (scale * symmetric.eigenvectors()).colwise().normalized();
  }
};

using KindAndSize = std::tuple<Laplacian, bool, std::uint32_t>;
class LaplacianKinds : public testing::TestWithParam<KindAndSize> {};

TEST_P(LaplacianKinds, HaveTheEigenvectorsOfADenseSolver) {
  const auto [normalisation, is_signed, vertices] = GetParam();
  const auto edges = random_graph(vertices, is_signed);
  const Eigen::MatrixXd expected = Oracle(vertices, edges).vectors(normalisation);
  const Eigen::Index trivial = is_signed ? 0 : 1;

  const Eigen::MatrixXd found = eigenvectors(vertices, edges, 3, {normalisation, is_signed});

  ASSERT_EQ(found.cols(), 3);
  for (Eigen::Index k = 0; k < 3; ++k) {
    EXPECT_NEAR(std::abs(found.col(k).dot(expected.col(k + trivial))), 1, 1e-3) << k;
  }
}

TEST_P(LaplacianKinds, GiveTheSameBitsTwice) {
  const auto [normalisation, is_signed, vertices] = GetParam();
  const auto edges = random_graph(vertices, is_signed);
  const LaplacianKind kind{normalisation, is_signed};

  EXPECT_EQ(eigenvectors(vertices, edges, 3, kind), eigenvectors(vertices, edges, 3, kind));
}

// Dense and sparse.
INSTANTIATE_TEST_SUITE_P(Equations2_11To2_14And4_14, LaplacianKinds,
                         testing::Combine(testing::Values(Laplacian::unnormalised,
                                                          Laplacian::symmetric,
                                                          Laplacian::random_walk),
                                          testing::Bool(), testing::Values(9, 40, 300)));

// Degrees 1, 4 and 3; eigenvalues 0, 1 and 2.
TEST(Equation2_14, HoldsForTheRandomWalkOfAPath) {
  const std::vector<WeightedEdge> path = {{0, 1, 1}, {1, 2, 3}};
  Eigen::Matrix3d random_walk;
  random_walk << 1, -1, 0, -0.25, 1, -0.75, 0, -1, 1;

  const Eigen::MatrixXd found = eigenvectors(3, path, 2, {Laplacian::random_walk, false});

  ASSERT_EQ(found.cols(), 2);
  EXPECT_TRUE((random_walk * found.col(0)).isApprox(1 * found.col(0), 1e-9));
  EXPECT_TRUE((random_walk * found.col(1)).isApprox(2 * found.col(1), 1e-9));
}

// Two triangles of friends, between whom all are enemies: the vector that is 1 in one and -1 in the
// other costs nothing.
TEST(Equation4_14, MapsTheIndicatorOfABalancedGraphToZero) {
  const std::vector<WeightedEdge> edges = {{0, 1, 1}, {1, 2, 1}, {0, 2, 1},  {3, 4, 1},
                                           {4, 5, 1}, {3, 5, 1}, {2, 3, -1}, {0, 5, -2}};
  Eigen::VectorXd indicator(6);
  indicator << 1, 1, 1, -1, -1, -1;

  const Eigen::MatrixXd found = eigenvectors(6, edges, 1, {Laplacian::unnormalised, true});

  EXPECT_NEAR(std::abs(found.col(0).dot(indicator.normalized())), 1, 1e-9);
}

}  // namespace
}  // namespace cleave::segmentation
