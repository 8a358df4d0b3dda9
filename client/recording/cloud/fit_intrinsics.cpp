// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/fit_intrinsics.hpp"

#include <cmath>
#include <cstddef>

namespace cleave::recording {
namespace {

constexpr double fit_tolerance_m = 1e-4;
constexpr std::size_t min_points = 100;

// Least squares of coordinate = a * (pixel * z) + b * z, where a = 1 / f and b = -c / f: linear,
// and what it minimises is an error in metres.
class AxisFit {
 public:
  void add(double pixel, double z, double coordinate) {
    const double s = pixel * z;
    ss_ += s * s;
    sz_ += s * z;
    zz_ += z * z;
    sc_ += s * coordinate;
    zc_ += z * coordinate;
  }
  // False where the points do not determine the axis.
  bool solve() {
    const double determinant = ss_ * zz_ - sz_ * sz_;
    if (!(determinant > 1e-9 * ss_ * zz_)) return false;
    a_ = (sc_ * zz_ - zc_ * sz_) / determinant;
    b_ = (ss_ * zc_ - sz_ * sc_) / determinant;
    return a_ > 0;
  }
  [[nodiscard]] bool explains(double pixel, double z, double coordinate) const {
    return std::abs((a_ * pixel + b_) * z - coordinate) <= fit_tolerance_m;
  }
  [[nodiscard]] float focal_length() const { return static_cast<float>(1 / a_); }
  [[nodiscard]] float principal_point() const { return static_cast<float>(-b_ / a_); }

 private:
  double ss_ = 0, sz_ = 0, zz_ = 0, sc_ = 0, zc_ = 0;
  double a_ = 0, b_ = 0;
};

// Calls visit(u, v, point) for every finite point, until it returns false.
template <class Visit>
bool all_points(const float* xyz, std::uint32_t width, std::uint32_t height, Visit visit) {
  for (std::uint32_t v = 0; v < height; ++v) {
    for (std::uint32_t u = 0; u < width; ++u, xyz += 3) {
      if (std::isfinite(xyz[2]) && !visit(u, v, xyz)) return false;
    }
  }
  return true;
}

}  // namespace

Intrinsics fit_intrinsics(const float* xyz, std::uint32_t width, std::uint32_t height) {
  if (height < 2) return {};
  AxisFit x, y;
  std::size_t points = 0;
  const bool in_front = all_points(xyz, width, height, [&](double u, double v, const float* p) {
    x.add(u, p[2], p[0]);
    y.add(v, p[2], p[1]);
    ++points;
    return p[2] > 0;
  });
  if (!in_front || points < min_points || !x.solve() || !y.solve()) return {};
  const bool explained = all_points(xyz, width, height, [&](double u, double v, const float* p) {
    return x.explains(u, p[2], p[0]) && y.explains(v, p[2], p[1]);
  });
  if (!explained) return {};
  return {x.focal_length(), y.focal_length(), x.principal_point(), y.principal_point()};
}

}  // namespace cleave::recording
