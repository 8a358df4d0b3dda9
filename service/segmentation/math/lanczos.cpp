// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/lanczos.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleave::segmentation {
namespace {

constexpr double tolerance = 1e-2;                       // residual, of the inverse's eigenvalue
constexpr double breakdown = 1e-10;                      // of the inverse's largest eigenvalue
constexpr std::uint32_t first_look = 6, look_again = 4;  // steps beyond `wanted`, and from then on

// Four sums at a time, in a fixed order.
double dot(std::span<const double> x, std::span<const double> y) {
  std::array<double, 4> sum{};
  std::size_t i = 0;
  for (; i + 4 <= x.size(); i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) sum[lane] += x[i + lane] * y[i + lane];
  }
  for (; i < x.size(); ++i) sum[0] += x[i] * y[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void add(double factor, std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += factor * x[i];
}

void scale(double factor, std::span<double> x) {
  for (double& value : x) value *= factor;
}

void take_off_mean(std::span<double> x) {
  double sum = 0;
  for (const double value : x) sum += value;
  const double mean = sum / static_cast<double>(x.size());
  for (double& value : x) value -= mean;
}

}  // namespace

std::span<double> Lanczos::basis(std::uint32_t k) {
  return {basis_.data() + k * size_, size_};
}

std::span<const double> Lanczos::column(std::uint32_t k) const {
  return {found_.data() + k * size_, size_};
}

// Takes off what vectors before `k` explain, twice for rounding's sake; returns what length is
// left.
double Lanczos::orthogonalise(std::uint32_t k) {
  const auto vector = basis(k);
  for (int pass = 0; pass < 2; ++pass) {
    if (constant_is_known_) {
      take_off_mean(vector);
    } else if (!known_.empty()) {
      add(-dot(vector, known_), known_, vector);
    }
    for (std::uint32_t j = 0; j < k; ++j) add(-dot(vector, basis(j)), basis(j), vector);
  }
  return std::sqrt(dot(vector, vector));
}

// Any direction will do that is not orthogonal to one that is sought.
void Lanczos::start_anew(std::uint32_t k) {
  const auto vector = basis(k);
  for (double& value : vector) {
    random_ = random_ * 1664525U + 1013904223U;  // Numerical Recipes' generator
    value = static_cast<double>(random_) * 0x1p-32 - 0.5;
  }
  scale(1 / orthogonalise(k), vector);
}

// Vector k + 1 of the basis, not yet of unit length; returns its length.
double Lanczos::step(const SparseLdl& matrix, std::uint32_t k) {
  const auto next = basis(k + 1);
  std::copy(basis(k).begin(), basis(k).end(), next.begin());
  matrix.solve(next);
  alpha_[k] = dot(next, basis(k));
  return orthogonalise(k + 1);
}

bool Lanczos::has_converged(std::uint32_t steps, std::uint32_t wanted, double beta) {
  const auto count = static_cast<Eigen::Index>(steps);
  tridiagonal_.computeFromTridiagonal(alpha_.head(count), beta_.head(count - 1));
  for (Eigen::Index k = count - 1; k >= count - static_cast<Eigen::Index>(wanted); --k) {
    const double residual = std::abs(beta * tridiagonal_.eigenvectors()(count - 1, k));
    if (residual > tolerance * tridiagonal_.eigenvalues()[k]) return false;
  }
  return true;
}

// The inverse's largest eigenvalues are the matrix's smallest.
void Lanczos::combine(std::uint32_t steps, std::uint32_t wanted) {
  found_.assign(wanted * size_, 0);
  for (std::uint32_t k = 0; k < wanted; ++k) {
    const std::span<double> column{found_.data() + k * size_, size_};
    for (std::uint32_t j = 0; j < steps; ++j) {
      add(tridiagonal_.eigenvectors()(j, steps - 1 - k), basis(j), column);
    }
  }
}

std::uint32_t Lanczos::find(const SparseLdl& matrix, std::uint32_t wanted) {
  constant_is_known_ = true;
  return iterate(matrix, wanted);
}

std::uint32_t Lanczos::find(const SparseLdl& matrix, std::uint32_t wanted,
                            std::span<const double> known) {
  constant_is_known_ = false;
  known_ = known;
  return iterate(matrix, wanted);
}

std::uint32_t Lanczos::iterate(const SparseLdl& matrix, std::uint32_t wanted) {
  size_ = matrix.size();
  const auto dimensions = static_cast<std::uint32_t>(std::min<std::size_t>(size_ - 1, max_basis));
  wanted = std::min({wanted, max_wanted, dimensions});
  basis_.resize((dimensions + std::size_t{1}) * size_);
  alpha_.resize(dimensions);
  beta_.resize(dimensions);
  random_ = 1;
  start_anew(0);
  std::uint32_t look = std::min(wanted + first_look, dimensions);
  for (std::uint32_t steps = 1;; ++steps) {
    beta_[steps - 1] = step(matrix, steps - 1);
    const bool is_last = steps == dimensions;
    // An invariant space was found whole: others may lie outside.
    const bool broke_down = beta_[steps - 1] <= breakdown * alpha_[0];
    if (steps == look) {
      if (has_converged(steps, wanted, beta_[steps - 1]) || is_last) {
        combine(steps, wanted);
        return wanted;
      }
      look = std::min(look + look_again, dimensions);
    }
    if (broke_down) {
      beta_[steps - 1] = 0;
      start_anew(steps);
    } else {
      scale(1 / beta_[steps - 1], basis(steps));
    }
  }
}

}  // namespace cleave::segmentation
