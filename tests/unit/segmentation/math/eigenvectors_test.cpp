// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/eigenvectors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numeric>
#include <random>

namespace cleave::segmentation {
namespace {

// A ring with chords: connected, with eigenvalues that differ.
std::vector<WeightedEdge> random_graph(std::uint32_t vertices, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> weight(0.05, 1);
  std::vector<WeightedEdge> edges;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    edges.push_back({v, (v + 1) % vertices, weight(random)});
    if (v + 7 < vertices) edges.push_back({v, v + 7, weight(random)});
  }
  return edges;
}

Eigen::MatrixXd laplacian(std::uint32_t vertices, const std::vector<WeightedEdge>& edges) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(vertices, vertices);
  for (const WeightedEdge& edge : edges) {
    matrix(edge.first, edge.first) += edge.weight;
    matrix(edge.second, edge.second) += edge.weight;
    matrix(edge.first, edge.second) -= edge.weight;
    matrix(edge.second, edge.first) -= edge.weight;
  }
  return matrix;
}

std::vector<std::uint32_t> all_vertices(std::uint32_t vertices) {
  std::vector<std::uint32_t> all(vertices);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

Eigen::MatrixXd eigenvectors(std::uint32_t vertices, const std::vector<WeightedEdge>& edges,
                             std::uint32_t wanted) {
  LaplacianEigensolver solver;
  solver.reset(vertices, edges);
  return solver.solve(all_vertices(vertices), edges, wanted);
}

class EigenvectorsOfSize : public testing::TestWithParam<std::uint32_t> {};

TEST_P(EigenvectorsOfSize, AreThoseOfADenseSolver) {
  const std::uint32_t vertices = GetParam();
  const auto edges = random_graph(vertices, vertices);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> oracle(laplacian(vertices, edges));
  const auto wanted = std::min<Eigen::Index>(5, Eigen::Index{vertices} - 1);

  const Eigen::MatrixXd found = eigenvectors(vertices, edges, 5);

  ASSERT_EQ(found.cols(), wanted);
  for (Eigen::Index k = 0; k < wanted; ++k) {
    EXPECT_NEAR(std::abs(found.col(k).dot(oracle.eigenvectors().col(k + 1))), 1, 1e-4) << k;
  }
}

TEST_P(EigenvectorsOfSize, AreTheSameBitsTwice) {
  const auto edges = random_graph(GetParam(), 9);

  EXPECT_EQ(eigenvectors(GetParam(), edges, 5), eigenvectors(GetParam(), edges, 5));
}

// Dense and sparse.
INSTANTIATE_TEST_SUITE_P(EverySolver, EigenvectorsOfSize, testing::Values(9, 30, 100, 500));

// Half of a graph, its vertices in no order.
TEST(Eigenvectors, OfASubgraphAreThoseOfItAlone) {
  const std::uint32_t half = 60;
  const auto edges = random_graph(2 * half, 4);
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i < half; ++i) vertices.push_back(2 * ((i * 7) % half));
  std::vector<WeightedEdge> named_as_whole, named_alone;
  for (const WeightedEdge& edge : random_graph(half, 5)) {
    named_as_whole.push_back({vertices[edge.first], vertices[edge.second], edge.weight});
    named_alone.push_back(edge);
  }
  LaplacianEigensolver solver;
  solver.reset(2 * half, edges);

  const Eigen::MatrixXd found = solver.solve(vertices, named_as_whole, 4);

  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> oracle(laplacian(half, named_alone));
  for (Eigen::Index k = 0; k < 4; ++k) {
    EXPECT_NEAR(std::abs(found.col(k).dot(oracle.eigenvectors().col(k + 1))), 1, 1e-4) << k;
  }
}

// Each eigenvalue of a ring but one is double: a single Krylov space holds one vector of the two.
TEST(Eigenvectors, OfARingSpanItsDoubleEigenspaces) {
  const std::uint32_t vertices = 64;
  std::vector<WeightedEdge> edges;
  for (std::uint32_t v = 0; v < vertices; ++v) edges.push_back({v, (v + 1) % vertices, 1});

  const Eigen::MatrixXd found = eigenvectors(vertices, edges, 4);

  const Eigen::MatrixXd l = laplacian(vertices, edges);
  for (Eigen::Index k = 0; k < found.cols(); ++k) {
    const double value = found.col(k).dot(l * found.col(k));
    EXPECT_LT((l * found.col(k) - value * found.col(k)).norm(), 1e-2 * l(0, 0)) << k;
    EXPECT_NEAR(found.col(k).norm(), 1, 1e-9);
  }
}

TEST(Eigenvectors, OfTwoVerticesAreOne) {
  const Eigen::MatrixXd found = eigenvectors(2, {{0, 1, 1.0}}, 10);

  ASSERT_EQ(found.cols(), 1);
  EXPECT_NEAR(found(0, 0), -found(1, 0), 1e-12);
}

}  // namespace
}  // namespace cleave::segmentation
