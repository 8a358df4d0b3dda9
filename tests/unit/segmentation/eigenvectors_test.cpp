#include "segmentation/eigenvectors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
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

class EigenvectorsOfSize : public testing::TestWithParam<std::uint32_t> {};

TEST_P(EigenvectorsOfSize, AreThoseOfADenseSolver) {
  const std::uint32_t vertices = GetParam();
  const auto edges = random_graph(vertices, vertices);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> oracle(laplacian(vertices, edges));
  const auto wanted = std::min<Eigen::Index>(5, Eigen::Index{vertices} - 1);

  const Eigen::MatrixXd found = laplacian_eigenvectors(vertices, edges, 5);

  ASSERT_EQ(found.cols(), wanted);
  for (Eigen::Index k = 0; k < wanted; ++k) {
    EXPECT_NEAR(std::abs(found.col(k).dot(oracle.eigenvectors().col(k + 1))), 1, 1e-4) << k;
  }
}

TEST_P(EigenvectorsOfSize, AreTheSameBitsTwice) {
  const auto edges = random_graph(GetParam(), 9);

  EXPECT_EQ(laplacian_eigenvectors(GetParam(), edges, 5),
            laplacian_eigenvectors(GetParam(), edges, 5));
}

// Dense, Eigen's and CHOLMOD's factorisation.
INSTANTIATE_TEST_SUITE_P(EverySolver, EigenvectorsOfSize, testing::Values(9, 30, 100, 500));

TEST(Eigenvectors, OfTwoVerticesAreOne) {
  const Eigen::MatrixXd found = laplacian_eigenvectors(2, {{0, 1, 1.0}}, 10);

  ASSERT_EQ(found.cols(), 1);
  EXPECT_NEAR(found(0, 0), -found(1, 0), 1e-12);
}

}  // namespace
}  // namespace cleave::segmentation
