// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/objectives.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace cleave::segmentation {
namespace {

// A triangle of weights 1, 2, 3 and a pair of weight 4, joined by edges of 0.5 and 0.25:
//
//   C1 = {0, 1, 2}: deg = 2 (1 + 2 + 3) = 12, cut = 0.75, vol = 12.75
//   C2 = {3, 4}:    deg = 2 * 4 = 8,         cut = 0.75, vol = 8.75
struct TriangleAndPair {
  std::vector<WeightedEdge> edges = {{0, 1, 1}, {1, 2, 2},   {0, 2, 3},
                                     {3, 4, 4}, {2, 3, 0.5}, {0, 4, 0.25}};
  std::vector<std::uint32_t> cluster = {0, 0, 0, 1, 1};
  [[nodiscard]] PartitionedGraph graph() const { return {edges, cluster, 2}; }
};

TEST(Equation2_9, IsTheWeightBetweenClusters) {
  EXPECT_DOUBLE_EQ(cut_size(TriangleAndPair().graph()), 0.75);
}

TEST(Equation2_15, IsTheRatioCut) {
  EXPECT_DOUBLE_EQ(ratio_cut(TriangleAndPair().graph()), 0.75 / 3 + 0.75 / 2);
}

TEST(Equation2_16, IsTheRatioAssociation) {
  EXPECT_DOUBLE_EQ(ratio_association(TriangleAndPair().graph()), 12.0 / 3 + 8.0 / 2);
}

TEST(Equation2_17, IsTheNormalisedCut) {
  EXPECT_DOUBLE_EQ(normalised_cut(TriangleAndPair().graph()), 0.75 / 12.75 + 0.75 / 8.75);
}

TEST(Equation2_18, IsTheNormalisedAssociation) {
  EXPECT_DOUBLE_EQ(normalised_association(TriangleAndPair().graph()), 12 / 12.75 + 8 / 8.75);
}

TEST(Equation2_19, IsTheMinMaxCut) {
  EXPECT_DOUBLE_EQ(min_max_cut(TriangleAndPair().graph()), 0.75 / 12 + 0.75 / 8);
}

TEST(Objectives, OfLoneVerticesAreDefined) {
  const std::vector<WeightedEdge> edges = {{0, 1, 2}};
  const std::vector<std::uint32_t> cluster = {0, 1, 2};  // vertex 2 has no edge
  const PartitionedGraph graph{edges, cluster, 3};

  EXPECT_DOUBLE_EQ(ratio_cut(graph), 4);
  EXPECT_DOUBLE_EQ(normalised_cut(graph), 2);
  EXPECT_DOUBLE_EQ(normalised_association(graph), 0);
  EXPECT_EQ(min_max_cut(graph), std::numeric_limits<double>::infinity());
}

// The identities of section 2.3.2, by matrices.
TEST(Objectives, AreTheTracesThatTheyAreRelaxedTo) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> weight(0.1, 1);
  constexpr std::uint32_t vertices = 12;
  constexpr std::uint32_t clusters = 3;
  std::vector<WeightedEdge> edges;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(vertices, vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    for (std::uint32_t u = v + 1; u < vertices; u += 1 + static_cast<std::uint32_t>(random() % 3)) {
      edges.push_back({v, u, weight(random)});
      a(v, u) = a(u, v) = edges.back().weight;
    }
  }
  std::vector<std::uint32_t> cluster(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) cluster[v] = v % clusters;
  const Eigen::VectorXd degree = a.rowwise().sum();
  const Eigen::MatrixXd l = Eigen::MatrixXd(degree.asDiagonal()) - a;
  Eigen::MatrixXd by_size = Eigen::MatrixXd::Zero(vertices, clusters);
  Eigen::MatrixXd by_volume = by_size;
  for (std::uint32_t v = 0; v < vertices; ++v)
    by_size(v, cluster[v]) = by_volume(v, cluster[v]) = 1;
  for (std::uint32_t c = 0; c < clusters; ++c) {
    by_volume.col(c) /= std::sqrt(by_volume.col(c).dot(degree));  // equation 2.25
    by_size.col(c).normalize();                                   // equation 2.22
  }
  const PartitionedGraph graph{edges, cluster, clusters};

  EXPECT_NEAR(ratio_cut(graph), (by_size.transpose() * l * by_size).trace(), 1e-12);
  EXPECT_NEAR(ratio_association(graph), (by_size.transpose() * a * by_size).trace(), 1e-12);
  EXPECT_NEAR(normalised_cut(graph), (by_volume.transpose() * l * by_volume).trace(), 1e-12);
  EXPECT_NEAR(normalised_association(graph), clusters - normalised_cut(graph), 1e-12);
}

TEST(Equation4_12, CountsFriendsApartAndEnemiesTogether) {
  // Friends 0-1, 2-3 (1 each) and 1-2 (0.5); enemies 0-3 (-1) and, once more, 0-1 (-0.25).
  const std::vector<WeightedEdge> edges = {
      {0, 1, 1}, {2, 3, 1}, {1, 2, 0.5}, {0, 3, -1}, {0, 1, -0.25}};
  const std::vector<std::uint32_t> cluster = {0, 0, 1, 1};
  const PartitionedGraph graph{edges, cluster, 2};

  EXPECT_DOUBLE_EQ(signed_cut(graph), 2 * 0.5 + 2 * 0.25);
  EXPECT_DOUBLE_EQ(signed_ratio_cut(graph), 1.5 * (0.5 + 0.5));
}

// x^T L x of the signed Laplacian (4.14), x being 1 in one cluster and -1 in the other, is twice
// the signed cut: what makes its smallest eigenvector the relaxation of equation 4.13.
TEST(Equation4_12, IsTheQuadraticFormOfTheSignedLaplacian) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> weight(-1, 1);
  for (int trial = 0; trial < 10; ++trial) {
    constexpr std::uint32_t vertices = 8;
    std::vector<WeightedEdge> edges;
    Eigen::MatrixXd l = Eigen::MatrixXd::Zero(vertices, vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) {
      for (std::uint32_t u = v + 1; u < vertices; ++u) {
        const double w = weight(random);
        edges.push_back({v, u, w});
        l(v, u) = l(u, v) = -w;
        l(v, v) += std::abs(w);
        l(u, u) += std::abs(w);
      }
    }
    std::vector<std::uint32_t> cluster(vertices);
    Eigen::VectorXd x(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) {
      cluster[v] = v < 2 ? 0 : random() % 2;
      x[v] = cluster[v] == 0 ? 1 : -1;
    }

    EXPECT_NEAR(x.dot(l * x), 2 * signed_cut({edges, cluster, 2}), 1e-12);
  }
}

}  // namespace
}  // namespace cleave::segmentation
