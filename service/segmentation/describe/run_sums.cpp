// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/describe/run_sums.hpp"

#include <algorithm>
#include <cstring>

#include "segmentation/math/multiversion.hpp"
#include "segmentation/math/simd.hpp"

namespace cleave::segmentation {
namespace {

// The last few of a range, with the last one repeated.
template <typename Vector>
inline __attribute__((always_inline)) void load_rest(const float* from, std::size_t count,
                                                     Vector& to) {
  constexpr std::size_t size = sizeof(Vector) / sizeof(float);
  for (std::size_t i = 0; i < size; ++i) to[i] = from[std::min(i, count - 1)];
}

CLEAVE_MULTIVERSION
void add_moments(const PointRange& points, double* sums) {
  std::array<Double4, 9> sum;
  std::memcpy(&sum, sums, sizeof(sum));
  for (std::size_t i = 0; i < points.count; i += 4) {
    Float4 narrow_x, narrow_y, narrow_z;
    Double4 weight = {1, 1, 1, 1};
    const std::size_t rest = points.count - i;
    if (rest >= 4) {
      load(points.x + i, narrow_x);
      load(points.y + i, narrow_y);
      load(points.z + i, narrow_z);
    } else {
      load_rest(points.x + i, rest, narrow_x);
      load_rest(points.y + i, rest, narrow_y);
      load_rest(points.z + i, rest, narrow_z);
      weight = Double4{1, rest > 1 ? 1.0 : 0.0, rest > 2 ? 1.0 : 0.0, 0};
    }
    const Double4 x = __builtin_convertvector(narrow_x, Double4) * weight;
    const Double4 y = __builtin_convertvector(narrow_y, Double4) * weight;
    const Double4 z = __builtin_convertvector(narrow_z, Double4) * weight;
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    sum[3] += x * x;
    sum[4] += x * y;
    sum[5] += x * z;
    sum[6] += y * y;
    sum[7] += y * z;
    sum[8] += z * z;
  }
  std::memcpy(sums, &sum, sizeof(sum));
}

struct Extent {
  std::array<Float8, 3> low, high;
  Int8 on_plane;
};

CLEAVE_MULTIVERSION
void add_extent(const PointRange& points, const std::array<std::array<float, 4>, 4>& direction,
                float plane_distance_m, Extent& result) {
  constexpr Int8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
  Extent extent = result;
  for (std::size_t i = 0; i < points.count; i += 8) {
    Float8 x, y, z;
    const std::size_t rest = std::min<std::size_t>(points.count - i, 8);
    if (rest == 8) {
      load(points.x + i, x);
      load(points.y + i, y);
      load(points.z + i, z);
    } else {
      load_rest(points.x + i, rest, x);
      load_rest(points.y + i, rest, y);
      load_rest(points.z + i, rest, z);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& d = direction[axis];
      const Float8 along = d[0] * x + d[1] * y + d[2] * z;
      extent.low[axis] = along < extent.low[axis] ? along : extent.low[axis];
      extent.high[axis] = along > extent.high[axis] ? along : extent.high[axis];
    }
    const auto& d = direction[3];
    const Float8 off = d[0] * x + d[1] * y + d[2] * z - d[3];
    const Int8 near = (off <= plane_distance_m) & (off >= -plane_distance_m);
    extent.on_plane -= near & (lane < static_cast<std::int32_t>(rest));  // true is -1
  }
  result = extent;
}

}  // namespace

void RunMoments::add(const PointRange& points) {
  add_moments(points, sum_[0].data());
  count_ += static_cast<double>(points.count);
}

Moments RunMoments::total() const {
  const auto sum = [this](std::size_t k) {
    return (sum_[k][0] + sum_[k][1]) + (sum_[k][2] + sum_[k][3]);
  };
  return {.n = count_,
          .x = sum(0),
          .y = sum(1),
          .z = sum(2),
          .xx = sum(3),
          .xy = sum(4),
          .xz = sum(5),
          .yy = sum(6),
          .yz = sum(7),
          .zz = sum(8)};
}

void RunExtent::aim(const Eigen::Matrix3f& axes, const Eigen::Vector3f& plane_normal,
                    const Eigen::Vector3f& on_plane, float plane_distance_m) {
  for (int axis = 0; axis < 3; ++axis) {
    state_.direction[static_cast<std::size_t>(axis)] = {axes(0, axis), axes(1, axis), axes(2, axis),
                                                        0};
  }
  state_.direction[3] = {plane_normal.x(), plane_normal.y(), plane_normal.z(),
                         plane_normal.dot(on_plane)};
  state_.plane_distance_m = plane_distance_m;
  for (auto& limit : state_.low) limit.fill(std::numeric_limits<float>::infinity());
  for (auto& limit : state_.high) limit.fill(-std::numeric_limits<float>::infinity());
  state_.on_plane.fill(0);
}

void RunExtent::add(const PointRange& points) {
  Extent extent;
  std::memcpy(&extent.low, &state_.low, sizeof(extent.low));
  std::memcpy(&extent.high, &state_.high, sizeof(extent.high));
  std::memcpy(&extent.on_plane, &state_.on_plane, sizeof(extent.on_plane));
  add_extent(points, state_.direction, state_.plane_distance_m, extent);
  std::memcpy(&state_.low, &extent.low, sizeof(extent.low));
  std::memcpy(&state_.high, &extent.high, sizeof(extent.high));
  std::memcpy(&state_.on_plane, &extent.on_plane, sizeof(extent.on_plane));
}

Eigen::Vector3f RunExtent::low() const {
  const auto least = [this](std::size_t axis) {
    return *std::min_element(state_.low[axis].begin(), state_.low[axis].end());
  };
  return {least(0), least(1), least(2)};
}

Eigen::Vector3f RunExtent::high() const {
  const auto most = [this](std::size_t axis) {
    return *std::max_element(state_.high[axis].begin(), state_.high[axis].end());
  };
  return {most(0), most(1), most(2)};
}

std::uint32_t RunExtent::points_on_plane() const {
  std::int32_t sum = 0;
  for (const std::int32_t count : state_.on_plane) sum += count;
  return static_cast<std::uint32_t>(sum);
}

}  // namespace cleave::segmentation
