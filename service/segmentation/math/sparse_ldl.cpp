// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/sparse_ldl.hpp"

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {

// The parent of a column is the first row below its diagonal in which it has an entry; on the way,
// the entries of every column are counted.
void SparseLdl::grow_tree(const SymmetricRows& matrix) {
  const std::uint32_t size = matrix.size();
  parent_.assign(size, no_index);
  seen_in_row_.assign(size, no_index);
  column_end_.assign(size, 0);
  for (std::uint32_t row = 0; row < size; ++row) {
    seen_in_row_[row] = row;
    for (std::uint32_t e = matrix.row_begin[row]; e < matrix.row_begin[row + 1]; ++e) {
      for (std::uint32_t c = matrix.column[e]; seen_in_row_[c] != row; c = parent_[c]) {
        if (parent_[c] == no_index) parent_[c] = row;
        seen_in_row_[c] = row;
        ++column_end_[c];
      }
    }
  }
  column_begin_.resize(size);
  std::uint32_t end = 0;
  for (std::uint32_t c = 0; c < size; ++c) {
    column_begin_[c] = end;
    end += column_end_[c];
    column_end_[c] = column_begin_[c];
  }
  row_.resize(end);
  value_.resize(end);
}

std::uint32_t SparseLdl::find_row_pattern(const SymmetricRows& matrix, std::uint32_t row) {
  std::uint32_t top = matrix.size();
  seen_in_row_[row] = row;
  for (std::uint32_t e = matrix.row_begin[row]; e < matrix.row_begin[row + 1]; ++e) {
    work_[matrix.column[e]] = matrix.value[e];
    std::uint32_t length = 0;
    for (std::uint32_t c = matrix.column[e]; seen_in_row_[c] != row; c = parent_[c]) {
      branch_[length++] = c;
      seen_in_row_[c] = row;
    }
    while (length > 0) path_[--top] = branch_[--length];
  }
  return top;
}

void SparseLdl::fill_row(const SymmetricRows& matrix, std::uint32_t row) {
  double pivot = matrix.diagonal[row];
  for (std::uint32_t i = find_row_pattern(matrix, row); i < matrix.size(); ++i) {
    const std::uint32_t c = path_[i];
    const double y = work_[c];
    work_[c] = 0;
    for (std::uint32_t e = column_begin_[c]; e < column_end_[c]; ++e) {
      work_[row_[e]] -= value_[e] * y;
    }
    const double entry = y / pivot_[c];
    pivot -= entry * y;
    row_[column_end_[c]] = row;
    value_[column_end_[c]++] = entry;
  }
  pivot_[row] = pivot;
}

void SparseLdl::factorise(const SymmetricRows& matrix) {
  grow_tree(matrix);
  seen_in_row_.assign(matrix.size(), no_index);
  for (auto* list : {&path_, &branch_}) list->resize(matrix.size());
  work_.assign(matrix.size(), 0);
  pivot_.resize(matrix.size());
  for (std::uint32_t row = 0; row < matrix.size(); ++row) fill_row(matrix, row);
}

void SparseLdl::solve(std::span<double> x) const {
  for (std::uint32_t c = 0; c < size(); ++c) {
    const double y = x[c];
    for (std::uint32_t e = column_begin_[c]; e < column_end_[c]; ++e) x[row_[e]] -= value_[e] * y;
  }
  for (std::uint32_t c = size(); c-- > 0;) {
    double y = x[c] / pivot_[c];
    for (std::uint32_t e = column_begin_[c]; e < column_end_[c]; ++e) y -= value_[e] * x[row_[e]];
    x[c] = y;
  }
}

}  // namespace cleave::segmentation
