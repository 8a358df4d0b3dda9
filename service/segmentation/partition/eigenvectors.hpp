// SPDX-License-Identifier: BSD-3-Clause
// The spectral relaxation: small eigenvectors of a graph's Laplacian (sections 2.2.2, 4.1.3.2 and,
// signed, 4.1.4).
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/math/elimination_order.hpp"
#include "segmentation/math/lanczos.hpp"
#include "segmentation/math/sparse_ldl.hpp"
#include "segmentation/math/weighted_edge.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

struct LaplacianKind {
  Laplacian normalisation = Laplacian::unnormalised;
  // Weights may be negative: degrees are sums of their magnitudes (equation 4.9), and no
  // eigenvector is trivial.
  bool is_signed = false;
};

// For a graph and the connected subgraphs that it is cut into. The same graph gives the same bits;
// no allocation once warm.
class LaplacianEigensolver {
 public:
  // A row a vertex, in the order of solve()'s argument; a column an eigenvector.
  using Vectors = Eigen::Map<const Eigen::MatrixXd>;

  // The whole graph, without loops and parallel edges: what comes after is a part of it.
  void reset(std::uint32_t vertices, std::span<const WeightedEdge> edges);

  // Unit eigenvectors of the `wanted` (at most 100) smallest eigenvalues of L = D - A (equation
  // 2.11; 4.14 if signed) or of what normalisation makes of it (2.13, 2.14), after the trivial one
  // where there is one, ascending; fewer where the graph has no more. For a connected subgraph of
  // two vertices or more, named as in the whole. The result is valid until the next call.
  [[nodiscard]] Vectors solve(std::span<const std::uint32_t> vertices,
                              std::span<const WeightedEdge> edges, std::uint32_t wanted,
                              LaplacianKind kind = {});

 private:
  // Measured: below, the dense solver is faster.
  static constexpr int max_dense = 24;
  using Dense = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_dense, max_dense>;

  void place_in_order(std::span<const std::uint32_t> vertices);
  void lay_out_rows(std::span<const WeightedEdge> edges);
  void normalise_rows();
  void turn_into_random_walk(std::uint32_t count);
  std::uint32_t solve_dense(std::span<const WeightedEdge> edges, std::uint32_t wanted,
                            LaplacianKind kind);
  std::uint32_t solve_sparse(std::span<const WeightedEdge> edges, std::uint32_t wanted,
                             LaplacianKind kind);

  EliminationOrder order_;
  SparseLdl factorisation_;
  Lanczos lanczos_;
  Eigen::SelfAdjointEigenSolver<Dense> dense_solver_;
  std::vector<int> rank_;               // of a vertex of the whole
  std::vector<std::uint32_t> by_rank_;  // rows of solve()'s argument
  std::vector<std::uint32_t> row_;      // of the matrix, of a vertex of the whole
  std::vector<std::uint32_t> fill_;
  SymmetricRows matrix_;
  std::vector<double> inverse_root_;  // of the degree of a row: the diagonal of D^(-1/2)
  std::vector<double> trivial_;
  std::vector<double> vectors_;
};

}  // namespace cleave::segmentation
