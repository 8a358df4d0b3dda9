// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/plane_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "segmentation/math/portable_math.hpp"

namespace cleave::segmentation {
namespace {

// Smallest eigenvalue of a symmetric matrix whose largest element is 1, in closed form
// (O. K. Smith, "Eigenvalues of a symmetric 3 x 3 matrix", CACM 1961), with two of Newton's steps.
double smallest_eigenvalue(const Eigen::Matrix3d& a) {
  constexpr double thirty_degrees_rad = std::numbers::pi / 6;
  constexpr double double_root = 1e-6;
  const double mean = a.trace() / 3;
  const Eigen::Matrix3d b = a - mean * Eigen::Matrix3d::Identity();
  const double p = std::sqrt(b.squaredNorm() / 6);
  if (p == 0) return mean;
  const double half_determinant = std::clamp(b.determinant() / (2 * p * p * p), -1.0, 1.0);
  double root = -2 * portable::sin(portable::acos(half_determinant) / 3 + thirty_degrees_rad);
  for (int step = 0; step < 2; ++step) {
    const double slope = 3 * (root * root - 1);
    if (slope > double_root) root -= (root * (root * root - 3) - 2 * half_determinant) / slope;
  }
  return mean + p * root;
}

}  // namespace

std::optional<Eigen::Vector3d> smallest_eigenvector(const Eigen::Matrix3d& matrix) {
  // Relative to the largest element: below it the cross products are rounding.
  constexpr double min_squared_cross_product = 1e-24;
  const double scale = matrix.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return std::nullopt;

  Eigen::Matrix3d a = matrix / scale;
  a.diagonal().array() -= smallest_eigenvalue(a);
  // The rows now span the plane across the eigenvector; two of them that are far from parallel
  // give it.
  const Eigen::Vector3d candidates[] = {a.row(0).cross(a.row(1)), a.row(0).cross(a.row(2)),
                                        a.row(1).cross(a.row(2))};
  const auto* best = std::max_element(
      std::begin(candidates), std::end(candidates),
      [](const auto& l, const auto& r) { return l.squaredNorm() < r.squaredNorm(); });
  if (best->squaredNorm() < min_squared_cross_product) return std::nullopt;
  return best->normalized();
}

Eigen::Vector3f direction_to_sensor(const Eigen::Vector3f& position) {
  const Eigen::Vector3d p = position.cast<double>();
  const double distance = p.norm();
  if (!(distance > 0)) return -Eigen::Vector3f::UnitZ();
  return (-p / distance).cast<float>();
}

Eigen::Vector3f unit_or_towards_sensor(const Eigen::Vector3f& sum,
                                       const Eigen::Vector3f& position) {
  const float length = sum.norm();
  if (!(length > 0)) return direction_to_sensor(position);
  return sum / length;
}

Eigen::Vector3f fit_normal(const Moments& points) {
  const Eigen::Vector3d mean = points.mean();
  const auto normal = points.n < 3 ? std::nullopt : smallest_eigenvector(points.covariance());
  if (!normal) return direction_to_sensor(mean.cast<float>());
  return (normal->dot(mean) > 0 ? Eigen::Vector3d(-*normal) : *normal).cast<float>();
}

float surface_variation(const Moments& points) {
  if (!(points.n > 0)) return 0;
  const Eigen::Matrix3d covariance = points.covariance();
  const double scale = covariance.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return 0;
  // What rounding makes negative is a plane.
  const double least = std::max(smallest_eigenvalue(covariance / scale), 0.0);
  return static_cast<float>(least / (covariance.trace() / scale));
}

}  // namespace cleave::segmentation
