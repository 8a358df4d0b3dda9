// SPDX-License-Identifier: BSD-3-Clause
// What runs of points add up to, several points at a time in a fixed order.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "segmentation/math/moments.hpp"

namespace cleave::segmentation {

// Coordinates of points that follow each other, metres.
struct PointRange {
  const float *x = nullptr, *y = nullptr, *z = nullptr;
  std::size_t count = 0;
};

class RunMoments {
 public:
  void add(const PointRange& points);
  [[nodiscard]] Moments total() const;

 private:
  static constexpr std::size_t lanes = 4, sums = 9;
  double count_ = 0;
  std::array<std::array<double, lanes>, sums> sum_{};
};

// How far points reach along three axes, and how many lie near a plane.
class RunExtent {
 public:
  // Columns of `axes`; the plane through `on_plane` across `plane_normal`.
  void aim(const Eigen::Matrix3f& axes, const Eigen::Vector3f& plane_normal,
           const Eigen::Vector3f& on_plane, float plane_distance_m);
  void add(const PointRange& points);
  [[nodiscard]] Eigen::Vector3f low() const;
  [[nodiscard]] Eigen::Vector3f high() const;
  [[nodiscard]] std::uint32_t points_on_plane() const;

 private:
  static constexpr std::size_t lanes = 8;
  struct State {
    std::array<std::array<float, 4>, 4> direction;  // axes, and the plane; offset last
    float plane_distance_m = 0;
    std::array<std::array<float, lanes>, 3> low, high;
    std::array<std::int32_t, lanes> on_plane;
  };
  State state_;
};

}  // namespace cleave::segmentation
