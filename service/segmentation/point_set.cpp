#include "segmentation/point_set.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::segmentation {

void gather_finite_points(const CloudView& cloud, PointSet& points) {
  const std::size_t capacity = cloud.size();
  for (auto* axis : {&points.x, &points.y, &points.z}) axis->resize(capacity);
  points.index.resize(capacity);
  points.all_in_front = true;

  std::size_t count = 0;
  for (std::size_t i = 0; i < capacity; ++i) {
    const float* p = cloud.point(i);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
    points.x[count] = std::clamp(p[0], -max_coordinate_m, max_coordinate_m);
    points.y[count] = std::clamp(p[1], -max_coordinate_m, max_coordinate_m);
    points.z[count] = std::clamp(p[2], -max_coordinate_m, max_coordinate_m);
    points.index[count] = static_cast<std::uint32_t>(i);
    points.all_in_front = points.all_in_front && p[2] > 0;
    ++count;
  }

  for (auto* axis : {&points.x, &points.y, &points.z}) axis->resize(count);
  points.index.resize(count);
}

}  // namespace cleave::segmentation
