// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/sparse_ldl.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace cleave::segmentation {
namespace {

// Diagonally dominant, hence positive definite; about `per_row` entries below the diagonal a row.
SymmetricRows random_matrix(std::uint32_t size, std::uint32_t per_row, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  SymmetricRows matrix;
  matrix.diagonal.assign(size, 0.5);
  for (std::uint32_t row = 0; row < size; ++row) {
    matrix.row_begin.push_back(static_cast<std::uint32_t>(matrix.column.size()));
    for (std::uint32_t column = 0; column < row; ++column) {
      if (random() % row >= per_row) continue;
      matrix.column.push_back(column);
      matrix.value.push_back(value(random));
      matrix.diagonal[row] += 1;
      matrix.diagonal[column] += 1;
    }
  }
  matrix.row_begin.push_back(static_cast<std::uint32_t>(matrix.column.size()));
  return matrix;
}

Eigen::MatrixXd dense(const SymmetricRows& matrix) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.size(), matrix.size());
  for (std::uint32_t row = 0; row < matrix.size(); ++row) {
    result(row, row) = matrix.diagonal[row];
    for (std::uint32_t e = matrix.row_begin[row]; e < matrix.row_begin[row + 1]; ++e) {
      result(row, matrix.column[e]) = result(matrix.column[e], row) = matrix.value[e];
    }
  }
  return result;
}

TEST(SparseLdl, SolvesAsADenseSolverDoes) {
  SparseLdl factorisation;  // one for all: nothing may be left of the matrix before
  for (const std::uint32_t size : {1U, 2U, 7U, 150U, 40U}) {
    const SymmetricRows matrix = random_matrix(size, 3, size);
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(size, -1, 2);

    factorisation.factorise(matrix);
    Eigen::VectorXd x = right;
    factorisation.solve({x.data(), size});

    EXPECT_LT((dense(matrix) * x - right).norm(), 1e-10 * right.norm()) << size;
  }
}

}  // namespace
}  // namespace cleave::segmentation
