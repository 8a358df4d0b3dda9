// SPDX-License-Identifier: BSD-3-Clause
// Clouds of every kind that someone may send, sound or not, each from its seed.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "segmentation/cloud_view.hpp"

namespace cleave::segmentation {

class RandomCloud {
 public:
  explicit RandomCloud(std::uint64_t seed) : random_(seed) {
    const bool organised = one_in(3) != 0;
    width_ = size();
    height_ = organised ? size() : 1;
    if (!organised) width_ *= 8;
    make_points();
    place();
    spoil();
    if (one_in(4) == 0) pose_ = random_pose();
    if (one_in(6) == 0) origin_m_ = {uniform(-1e6, 1e6), uniform(-1e6, 1e6), uniform(-10, 10)};
  }

  [[nodiscard]] CloudView view() const {
    return {xyz_.data(), stride_, width_, height_, origin_m_, pose_};
  }
  // Up to `n` - 1.
  std::uint32_t one_in(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }

 private:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / static_cast<double>(random_.max());
  }
  std::uint32_t size() { return one_in(8) == 0 ? 1 + one_in(3) : 2 + one_in(36); }

  [[nodiscard]] std::size_t count() const { return std::size_t{width_} * height_; }

  // On a surface, as a pinhole or an orthographic camera samples it, or anywhere.
  void make_points() {
    const std::uint32_t surface = one_in(6);
    const std::uint32_t projection = one_in(4);
    const double pitch = uniform(0.001, 0.05);
    const double tilt = uniform(-2, 2), step = uniform(-0.3, 0.3), noise = uniform(-0.01, 0.01);
    const auto columns = static_cast<double>(height_ > 1 ? width_ : 1 + width_ / 8);
    for (std::size_t i = 0; i < count(); ++i) {
      const double u = pitch * (std::fmod(static_cast<double>(i), columns) - columns / 2);
      const double v = pitch * (std::floor(static_cast<double>(i) / columns) - height_ / 2.0);
      double depth = 1 + std::max(noise, 0.0) * uniform(-1, 1);
      if (surface == 1) depth *= 1 / std::max(0.1, 1 + tilt * u + tilt * v);
      if (surface == 2) depth += u > 0 ? step : 0;
      if (surface == 3) depth += (u * u + v * v) * tilt;
      if (surface == 4) depth = uniform(0.1, 3);
      const double across = projection == 1 ? 1 : depth;
      Eigen::Vector3d point(u * across, v * across, depth);
      if (projection == 2) point = Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      if (surface == 5) point = (one_in(2) == 0 ? u : 1) * Eigen::Vector3d(1, 2, 3);
      points_.push_back(point);
    }
  }

  // In a random frame, storage order, scale and stride.
  void place() {
    if (one_in(2) == 0) {
      const SensorPose pose = random_pose();
      const auto& [w, x, y, z] = pose.orientation;
      const Eigen::Quaterniond turn(w, x, y, z);
      const Eigen::Vector3d shift(pose.position_m[0], pose.position_m[1], pose.position_m[2]);
      for (Eigen::Vector3d& point : points_) point = turn * point + shift;
    }
    if (one_in(3) == 0) std::reverse(points_.begin(), points_.end());
    if (one_in(3) == 0) transpose();
    if (one_in(8) == 0) std::shuffle(points_.begin(), points_.end(), random_);
    const double scale = one_in(3) == 0 ? std::pow(10, uniform(-30, 30)) : 1;
    stride_ = 3 + one_in(3);
    xyz_.assign(count() * stride_, 7);
    for (std::size_t i = 0; i < count(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        xyz_[i * stride_ + static_cast<std::size_t>(axis)] =
            static_cast<float>(scale * points_[i][axis]);
      }
    }
  }

  void transpose() {
    std::vector<Eigen::Vector3d> turned;
    for (std::uint32_t column = 0; column < width_; ++column) {
      for (std::uint32_t row = 0; row < height_; ++row) {
        turned.push_back(points_[std::size_t{row} * width_ + column]);
      }
    }
    points_ = turned;
    if (height_ > 1) std::swap(width_, height_);
  }

  SensorPose random_pose() {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1))
            .normalized();
    const double far = std::pow(10, uniform(-2, 3));
    return {{uniform(-far, far), uniform(-far, far), uniform(-far, far)},
            {turn.w(), turn.x(), turn.y(), turn.z()}};
  }

  // Points that are none, in patterns; points twice; points that stray.
  void spoil() {
    using Limits = std::numeric_limits<float>;
    const std::array<float, 10> odd = {Limits::quiet_NaN(),
                                       Limits::infinity(),
                                       -Limits::infinity(),
                                       0,
                                       -0.0F,
                                       Limits::denorm_min(),
                                       1e-20F,
                                       Limits::max(),
                                       -Limits::max(),
                                       -1};
    const std::uint32_t pattern = one_in(6);
    const std::uint32_t period = 1 + one_in(pattern == 5 ? 2 : 40);
    for (std::size_t i = 0; i < count(); ++i) {
      float* p = &xyz_[i * stride_];
      const bool chosen =
          (pattern == 1 && one_in(period) == 0) || (pattern == 2 && (i / width_) % period == 0) ||
          (pattern == 3 && (i % width_) % period == 0) || (pattern == 5 && one_in(period) == 0);
      if (chosen) std::fill_n(p, 3, odd[one_in(pattern == 5 ? 10 : 4)]);
      if (pattern == 4 && one_in(period) == 0) p[one_in(3)] = odd[one_in(10)];
      if (pattern == 5 && i > 0) std::copy_n(p - stride_, 3, p);
    }
  }

  std::mt19937_64 random_;
  std::uint32_t width_ = 1, height_ = 1;
  std::size_t stride_ = 3;
  std::vector<Eigen::Vector3d> points_;
  std::vector<float> xyz_;
  std::array<double, 3> origin_m_ = {0, 0, 0};
  std::optional<SensorPose> pose_;
};

}  // namespace cleave::segmentation
