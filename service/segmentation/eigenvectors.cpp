#include "segmentation/eigenvectors.hpp"

#include <algorithm>
#include <numeric>

namespace cleave::segmentation {
namespace {

// L is singular; L + shift I is not, and its inverse turns small eigenvalues into large ones.
constexpr double shift = 1e-3;

}  // namespace

void LaplacianEigensolver::reset(std::uint32_t vertices, std::span<const WeightedEdge> edges) {
  const auto ranks = order_.ranks(vertices, edges);
  rank_.assign(ranks.begin(), ranks.end());
  row_.resize(vertices);
}

// Rows of the matrix follow the whole graph's order of elimination.
void LaplacianEigensolver::place_in_order(std::span<const std::uint32_t> vertices) {
  by_rank_.resize(vertices.size());
  std::iota(by_rank_.begin(), by_rank_.end(), 0U);
  std::sort(by_rank_.begin(), by_rank_.end(), [&](std::uint32_t l, std::uint32_t r) {
    return rank_[vertices[l]] < rank_[vertices[r]];
  });
  for (std::uint32_t row = 0; row < by_rank_.size(); ++row) row_[vertices[by_rank_[row]]] = row;
}

void LaplacianEigensolver::lay_out_rows(std::span<const WeightedEdge> edges) {
  const std::size_t size = by_rank_.size();
  matrix_.diagonal.assign(size, shift);
  matrix_.row_begin.assign(size + 1, 0);
  for (const WeightedEdge& edge : edges) {
    const auto [column, row] = std::minmax(row_[edge.first], row_[edge.second]);
    matrix_.diagonal[column] += edge.weight;
    matrix_.diagonal[row] += edge.weight;
    ++matrix_.row_begin[row + 1];
  }
  for (std::size_t row = 0; row < size; ++row) matrix_.row_begin[row + 1] += matrix_.row_begin[row];
  fill_.assign(matrix_.row_begin.begin(), matrix_.row_begin.end() - 1);
  matrix_.column.resize(edges.size());
  matrix_.value.resize(edges.size());
  for (const WeightedEdge& edge : edges) {
    const auto [column, row] = std::minmax(row_[edge.first], row_[edge.second]);
    matrix_.column[fill_[row]] = column;
    matrix_.value[fill_[row]++] = -edge.weight;
  }
}

std::uint32_t LaplacianEigensolver::solve_dense(std::span<const WeightedEdge> edges,
                                                std::uint32_t wanted) {
  const auto size = static_cast<Eigen::Index>(by_rank_.size());
  Dense laplacian = Dense::Zero(size, size);
  for (const WeightedEdge& edge : edges) {
    const auto [column, row] = std::minmax(row_[edge.first], row_[edge.second]);
    laplacian(column, column) += edge.weight;
    laplacian(row, row) += edge.weight;
    laplacian(row, column) -= edge.weight;
  }
  dense_solver_.compute(laplacian);  // looks at the lower triangle only
  const std::uint32_t count = std::min(wanted, static_cast<std::uint32_t>(size) - 1);
  vectors_.resize(count * by_rank_.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    for (std::size_t row = 0; row < by_rank_.size(); ++row) {
      vectors_[k * by_rank_.size() + by_rank_[row]] =
          dense_solver_.eigenvectors()(static_cast<Eigen::Index>(row), k + 1);
    }
  }
  return count;
}

std::uint32_t LaplacianEigensolver::solve_sparse(std::span<const WeightedEdge> edges,
                                                 std::uint32_t wanted) {
  lay_out_rows(edges);
  factorisation_.factorise(matrix_);
  const std::uint32_t count = lanczos_.find(factorisation_, wanted);
  vectors_.resize(count * by_rank_.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    const auto column = lanczos_.column(k);
    for (std::size_t row = 0; row < by_rank_.size(); ++row) {
      vectors_[k * by_rank_.size() + by_rank_[row]] = column[row];
    }
  }
  return count;
}

LaplacianEigensolver::Vectors LaplacianEigensolver::solve(std::span<const std::uint32_t> vertices,
                                                          std::span<const WeightedEdge> edges,
                                                          std::uint32_t wanted) {
  place_in_order(vertices);
  const std::uint32_t count =
      vertices.size() <= max_dense ? solve_dense(edges, wanted) : solve_sparse(edges, wanted);
  return {vectors_.data(), static_cast<Eigen::Index>(vertices.size()),
          static_cast<Eigen::Index>(count)};
}

}  // namespace cleave::segmentation
