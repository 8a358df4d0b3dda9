// SPDX-License-Identifier: BSD-3-Clause
// The projective map that takes points to where they are seen, by the direct linear transform
// (Hartley and Zisserman, "Multiple View Geometry", 4.1 and 7.1), in spite of strays.
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <vector>

#include "segmentation/view/middle.hpp"

namespace cleave::segmentation {

// `N` homogeneous coordinates to pixels: 3 are directions, or points of a plane; 4 are points.
template <int N>
class ProjectiveFit {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, 3, N>;

  void clear() { all_.clear(); }
  // `from`: not 0; its length does not matter. `to`: about 1 large.
  void add(const Vector& from, const Eigen::Vector2d& to) {
    all_.push_back({from.normalized(), to, true});
  }

  // Least squares, three times over: what is far off the last map does not count for the next. Zero
  // if nothing was added.
  [[nodiscard]] Matrix solve() {
    if (all_.empty()) return Matrix::Zero();
    constexpr int rounds = 3;
    Matrix map = solve_once();
    for (int round = 1; round < rounds; ++round) {
      drop_strays(map);
      map = solve_once();
    }
    return map;
  }

 private:
  struct Pair {
    Vector from;
    Eigen::Vector2d to;
    bool counts;
  };

  [[nodiscard]] Matrix solve_once() const {
    using Square = Eigen::Matrix<double, 3 * N, 3 * N>;
    Square sum = Square::Zero();
    for (const Pair& pair : all_) {
      if (!pair.counts) continue;
      const Eigen::Matrix<double, N, N> square = pair.from * pair.from.transpose();
      sum.template block<N, N>(0, 0) += square;
      sum.template block<N, N>(0, 2 * N) -= pair.to.x() * square;
      sum.template block<N, N>(N, 2 * N) -= pair.to.y() * square;
      sum.template block<N, N>(2 * N, 2 * N) += pair.to.squaredNorm() * square;
    }
    sum.template block<N, N>(N, N) = sum.template block<N, N>(0, 0);
    sum.template block<N, N>(2 * N, 0) = sum.template block<N, N>(0, 2 * N);
    sum.template block<N, N>(2 * N, N) = sum.template block<N, N>(N, 2 * N);
    const Eigen::SelfAdjointEigenSolver<Square> solver(sum);
    const Eigen::Matrix<double, 3 * N, 1> least = solver.eigenvectors().col(0);
    Matrix map;
    for (int row = 0; row < 3; ++row) map.row(row) = least.template segment<N>(row * N);
    return map;
  }

  void drop_strays(const Matrix& map) {
    constexpr double far = 9;  // times the median, squared
    constexpr double least = 1e-12;
    constexpr double nowhere = 1e12;
    misses_.clear();
    for (const Pair& pair : all_) {
      const Eigen::Vector3d seen = map * pair.from;
      const double miss = (seen.head<2>() / seen.z() - pair.to).squaredNorm();
      misses_.push_back(miss < nowhere ? miss : nowhere);
    }
    sorted_ = misses_;
    const double limit = far * std::max(median_of(sorted_), least);
    for (std::size_t i = 0; i < all_.size(); ++i) all_[i].counts = misses_[i] <= limit;
  }

  std::vector<Pair> all_;
  std::vector<double> misses_, sorted_;
};

}  // namespace cleave::segmentation
