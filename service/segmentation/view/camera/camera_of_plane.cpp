// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/camera/camera_of_plane.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace cleave::segmentation {
namespace {

// Of an image 1 large, from what right angles and equal lengths on the plane look like (Zhang, "A
// flexible new technique for camera calibration", 2000, equations 3 and 4).
double focal_length(const Eigen::Matrix3d& homography) {
  constexpr double guess = 0.9;  // 58 deg of view
  constexpr double least = 0.2, most = 10;
  constexpr double face_on = 1e-3;
  const Eigen::Vector2d a = homography.col(0).head<2>();
  const Eigen::Vector2d b = homography.col(1).head<2>();
  const double a_z = homography(2, 0);
  const double b_z = homography(2, 1);
  const Eigen::Vector2d across(a.dot(b), a.squaredNorm() - b.squaredNorm());
  const Eigen::Vector2d along(a_z * b_z, a_z * a_z - b_z * b_z);
  if (!(across.norm() > face_on * (a.squaredNorm() + b.squaredNorm()))) return guess;
  const double inverse_square = -across.dot(along) / across.squaredNorm();
  if (!(inverse_square > 0)) return guess;
  const double focal = 1 / std::sqrt(inverse_square);
  return focal > least && focal < most ? focal : guess;
}

}  // namespace

ScenePlane plane_through(const std::vector<SampledPixel>& pixels, const Eigen::Vector3d& middle,
                         double extent_m) {
  constexpr double far = 20;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double count = 0;
  for (const SampledPixel& p : pixels) {
    const Eigen::Vector3d point = (p.point - middle) / extent_m;
    if (!(point.norm() < far)) continue;
    sum += point * point.transpose();
    mean += point;
    count += 1;
  }
  if (!(count > 0)) return {};
  mean /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum / count -
                                                              mean * mean.transpose());
  const Eigen::Vector3d& squares = solver.eigenvalues();
  ScenePlane plane;
  plane.axes.col(0) = solver.eigenvectors().col(2);
  plane.axes.col(1) = solver.eigenvectors().col(1);
  plane.axes.col(2) = plane.axes.col(0).cross(plane.axes.col(1));
  plane.height = plane.axes.col(2).dot(mean);
  if (squares[2] > 0) plane.flatness = std::sqrt(std::max(squares[0], 0.0) / squares[2]);
  return plane;
}

Camera camera_of_plane(const Eigen::Matrix3d& homography) {
  const double focal = focal_length(homography);
  Eigen::Matrix3d columns = homography;
  columns.topRows<2>() /= focal;
  const double scale = std::sqrt(columns.col(0).norm() * columns.col(1).norm());
  columns /= columns(2, 2) > 0 ? scale : -scale;
  Eigen::Matrix3d turn;  // from the plane's axes to the camera's
  turn.col(0) = columns.col(0).normalized();
  turn.col(2) = turn.col(0).cross(columns.col(1)).normalized();
  turn.col(1) = turn.col(2).cross(turn.col(0));
  Camera camera;
  camera.centre = -turn.transpose() * columns.col(2);
  camera.projection = Eigen::Vector3d(focal, focal, 1).asDiagonal() * turn;
  return camera;
}

}  // namespace cleave::segmentation
