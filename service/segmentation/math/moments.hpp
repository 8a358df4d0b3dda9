// SPDX-License-Identifier: BSD-3-Clause
// Sums over points from which a plane can be fitted; sums of disjoint sets add up.
#pragma once

#include <Eigen/Core>

namespace cleave::segmentation {

struct Moments {
  double n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add_point(double px, double py, double pz) {
    n += 1;
    x += px;
    y += py;
    z += pz;
    xx += px * px;
    xy += px * py;
    xz += px * pz;
    yy += py * py;
    yz += py * pz;
    zz += pz * pz;
  }

  Moments& operator+=(const Moments& other) {
    n += other.n;
    x += other.x;
    y += other.y;
    z += other.z;
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
    return *this;
  }

  // Both need n > 0.
  [[nodiscard]] Eigen::Vector3d mean() const { return Eigen::Vector3d(x, y, z) / n; }

  // Equation 2.1.
  [[nodiscard]] Eigen::Matrix3d covariance() const {
    const Eigen::Vector3d m = mean();
    Eigen::Matrix3d c;
    c << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return c / n - m * m.transpose();
  }
};

}  // namespace cleave::segmentation
