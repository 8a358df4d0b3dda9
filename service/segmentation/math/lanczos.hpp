// SPDX-License-Identifier: BSD-3-Clause
// A few eigenvectors of a matrix that is known by what its inverse does.
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/math/sparse_ldl.hpp"

namespace cleave::segmentation {

// Lanczos iteration with full reorthogonalisation on the inverse of a factored matrix, in the space
// orthogonal to an eigenvector that is known beforehand, if one is. The start is fixed and sums are
// taken in a fixed order: the same matrix gives the same bits. No allocation once warm.
class Lanczos {
 public:
  static constexpr std::uint32_t max_wanted = 100;

  // Eigenvectors of the `wanted` (1 to max_wanted, less than the matrix has rows) smallest
  // eigenvalues but the known one's, ascending; vector k is column(k). Returns their number. Known
  // is the constant vector (of a shifted Laplacian), or `known`, of unit length; nothing if empty.
  std::uint32_t find(const SparseLdl& matrix, std::uint32_t wanted);
  std::uint32_t find(const SparseLdl& matrix, std::uint32_t wanted, std::span<const double> known);
  [[nodiscard]] std::span<const double> column(std::uint32_t k) const;

 private:
  static constexpr int max_basis = 128;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_basis, max_basis>;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_basis, 1>;

  std::uint32_t iterate(const SparseLdl& matrix, std::uint32_t wanted);
  [[nodiscard]] std::span<double> basis(std::uint32_t k);
  void start_anew(std::uint32_t k);
  double orthogonalise(std::uint32_t k);
  double step(const SparseLdl& matrix, std::uint32_t k);
  [[nodiscard]] bool has_converged(std::uint32_t steps, std::uint32_t wanted, double beta);
  void combine(std::uint32_t steps, std::uint32_t wanted);

  std::size_t size_ = 0;
  bool constant_is_known_ = true;  // or else known_ is
  std::span<const double> known_;
  std::uint32_t random_ = 0;
  std::vector<double> basis_, found_;  // columns
  SmallVector alpha_, beta_;           // the tridiagonal matrix
  Eigen::SelfAdjointEigenSolver<Small> tridiagonal_;
};

}  // namespace cleave::segmentation
