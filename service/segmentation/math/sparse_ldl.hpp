// SPDX-License-Identifier: BSD-3-Clause
// A sparse symmetric positive definite matrix, factored as L D L^T.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::segmentation {

// The strictly lower triangle by rows, columns of a row in any order, and the diagonal.
struct SymmetricRows {
  std::vector<std::uint32_t> row_begin;  // one more than rows
  std::vector<std::uint32_t> column;
  std::vector<double> value;
  std::vector<double> diagonal;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(diagonal.size()); }
};

// Row by row along the elimination tree, in the matrix's own order (T. Davis, "Direct Methods for
// Sparse Linear Systems", 2006, chapter 4). Deterministic; no allocation once warm.
class SparseLdl {
 public:
  void factorise(const SymmetricRows& matrix);
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(pivot_.size()); }
  // x becomes the solution for the right-hand side x.
  void solve(std::span<double> x) const;

 private:
  void grow_tree(const SymmetricRows& matrix);
  // Leaves the columns of L's row, before the diagonal, in path_ from the returned place to its
  // end: a column stands before those that depend on it.
  std::uint32_t find_row_pattern(const SymmetricRows& matrix, std::uint32_t row);
  void fill_row(const SymmetricRows& matrix, std::uint32_t row);

  std::vector<std::uint32_t> parent_;  // elimination tree
  std::vector<std::uint32_t> seen_in_row_;
  std::vector<std::uint32_t> path_, branch_;
  std::vector<std::uint32_t> column_begin_, column_end_, row_;  // L by columns
  std::vector<double> value_;
  std::vector<double> pivot_;  // D
  std::vector<double> work_;
};

}  // namespace cleave::segmentation
