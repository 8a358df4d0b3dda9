// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/eigenvectors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cleave::segmentation {
namespace {

// L is singular; L + shift I is not, and its inverse turns small eigenvalues into large ones.
constexpr double shift = 1e-3;

// 0 for a vertex of no degree: its row of a normalised Laplacian is 0.
double inverse_root_of(double degree) {
  return degree > 0 ? 1 / std::sqrt(degree) : 0;
}

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
    matrix_.diagonal[column] += std::abs(edge.weight);
    matrix_.diagonal[row] += std::abs(edge.weight);
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

// Equation 2.13, and the vector that it maps to zero.
void LaplacianEigensolver::normalise_rows() {
  const std::size_t size = by_rank_.size();
  inverse_root_.resize(size);
  trivial_.resize(size);
  double degrees = 0;
  for (std::size_t row = 0; row < size; ++row) {
    const double degree = matrix_.diagonal[row] - shift;
    inverse_root_[row] = inverse_root_of(degree);
    matrix_.diagonal[row] = degree * inverse_root_[row] * inverse_root_[row] + shift;
    trivial_[row] = std::sqrt(std::max(degree, 0.0));
    degrees += trivial_[row] * trivial_[row];
  }
  for (double& value : trivial_) value /= std::sqrt(degrees);
  for (std::size_t row = 0; row < size; ++row) {
    for (std::uint32_t e = matrix_.row_begin[row]; e < matrix_.row_begin[row + 1]; ++e) {
      matrix_.value[e] *= inverse_root_[row] * inverse_root_[matrix_.column[e]];
    }
  }
}

// L_rw v = lambda v where v = D^(-1/2) u and L_sym u = lambda u.
void LaplacianEigensolver::turn_into_random_walk(std::uint32_t count) {
  const std::size_t size = by_rank_.size();
  for (std::uint32_t k = 0; k < count; ++k) {
    double squares = 0;
    for (std::size_t row = 0; row < size; ++row) {
      double& value = vectors_[k * size + by_rank_[row]];
      value *= inverse_root_[row];
      squares += value * value;
    }
    for (std::size_t row = 0; row < size && squares > 0; ++row) {
      vectors_[k * size + row] /= std::sqrt(squares);
    }
  }
}

std::uint32_t LaplacianEigensolver::solve_dense(std::span<const WeightedEdge> edges,
                                                std::uint32_t wanted, LaplacianKind kind) {
  const auto size = static_cast<Eigen::Index>(by_rank_.size());
  Dense laplacian = Dense::Zero(size, size);
  for (const WeightedEdge& edge : edges) {
    const auto [column, row] = std::minmax(row_[edge.first], row_[edge.second]);
    laplacian(column, column) += std::abs(edge.weight);
    laplacian(row, row) += std::abs(edge.weight);
    laplacian(row, column) -= edge.weight;
  }
  if (kind.normalisation != Laplacian::unnormalised) {
    inverse_root_.resize(by_rank_.size());
    for (Eigen::Index row = 0; row < size; ++row) {
      inverse_root_[static_cast<std::size_t>(row)] = inverse_root_of(laplacian(row, row));
    }
    const Eigen::Map<const Eigen::VectorXd> scale(inverse_root_.data(), size);
    for (Eigen::Index row = 0; row < size; ++row) {
      for (Eigen::Index c = 0; c <= row; ++c) laplacian(row, c) *= scale[row] * scale[c];
    }
  }
  dense_solver_.compute(laplacian);  // looks at the lower triangle only
  const std::uint32_t trivial = kind.is_signed ? 0 : 1;
  const std::uint32_t count = std::min(wanted, static_cast<std::uint32_t>(size) - trivial);
  vectors_.resize(count * by_rank_.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    for (std::size_t row = 0; row < by_rank_.size(); ++row) {
      vectors_[k * by_rank_.size() + by_rank_[row]] =
          dense_solver_.eigenvectors()(static_cast<Eigen::Index>(row), k + trivial);
    }
  }
  return count;
}

std::uint32_t LaplacianEigensolver::solve_sparse(std::span<const WeightedEdge> edges,
                                                 std::uint32_t wanted, LaplacianKind kind) {
  lay_out_rows(edges);
  const bool is_normalised = kind.normalisation != Laplacian::unnormalised;
  if (is_normalised) normalise_rows();
  factorisation_.factorise(matrix_);
  std::uint32_t count = 0;
  if (kind.is_signed) {
    count = lanczos_.find(factorisation_, wanted, {});
  } else if (is_normalised) {
    count = lanczos_.find(factorisation_, wanted, trivial_);
  } else {
    count = lanczos_.find(factorisation_, wanted);
  }
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
                                                          std::uint32_t wanted,
                                                          LaplacianKind kind) {
  place_in_order(vertices);
  const std::uint32_t count = vertices.size() <= max_dense ? solve_dense(edges, wanted, kind)
                                                           : solve_sparse(edges, wanted, kind);
  if (kind.normalisation == Laplacian::random_walk) turn_into_random_walk(count);
  return {vectors_.data(), static_cast<Eigen::Index>(vertices.size()),
          static_cast<Eigen::Index>(count)};
}

}  // namespace cleave::segmentation
