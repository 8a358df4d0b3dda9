// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/points/point_set.hpp"

#include <algorithm>

#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {
namespace {

void resize(PointSet& points, std::size_t count) {
  for (auto* axis : {&points.x, &points.y, &points.z}) axis->resize(count);
  points.index.resize(count);
}

}  // namespace

void gather_measured_points(const CloudView& cloud, PointSet& points) {
  const std::size_t capacity = cloud.size();
  resize(points, capacity);
  points.behind = 0;

  std::size_t count = 0;
  for (std::size_t i = 0; i < capacity; ++i) {
    const float* p = cloud.point(i);
    if (!is_measured(p)) continue;
    points.x[count] = std::clamp(p[0], -max_coordinate_m, max_coordinate_m);
    points.y[count] = std::clamp(p[1], -max_coordinate_m, max_coordinate_m);
    points.z[count] = std::clamp(p[2], -max_coordinate_m, max_coordinate_m);
    points.index[count] = static_cast<std::uint32_t>(i);
    points.behind += p[2] > 0 ? 0U : 1U;
    ++count;
  }
  resize(points, count);
}

void drop_points_behind(PointSet& points) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points.z[i] > 0)) continue;
    points.x[count] = points.x[i];
    points.y[count] = points.y[i];
    points.z[count] = points.z[i];
    points.index[count] = points.index[i];
    ++count;
  }
  resize(points, count);
  points.behind = 0;
}

}  // namespace cleave::segmentation
