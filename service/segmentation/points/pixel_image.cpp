// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/points/pixel_image.hpp"

#include "segmentation/math/multiversion.hpp"
#include "segmentation/points/point_set.hpp"
#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {

void PixelImage::lay_out(const ImageLayout& wanted) {
  if (layout == wanted && !z.empty()) return;
  layout = wanted;
  x.assign(layout.size(), 0);
  y.assign(layout.size(), 0);
  z.assign(layout.size(), no_depth);
  segment.assign(layout.size(), no_segment);
}

namespace {

inline float within_bounds(float coordinate) {
  const float low = coordinate > -max_coordinate_m ? coordinate : -max_coordinate_m;
  return low < max_coordinate_m ? low : max_coordinate_m;
}

// Points of a row into planes; returns how many of them are not in front of the sensor. Inlined, so
// that the loop is vectorised where the compiler knows the stride.
inline __attribute__((always_inline)) int split_row(const float* __restrict p, std::size_t stride,
                                                    std::size_t count, float* __restrict x,
                                                    float* __restrict y, float* __restrict z) {
  int behind = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float px = p[i * stride];
    const float py = p[i * stride + 1];
    const float pz = p[i * stride + 2];
    const bool measured = is_measured(px, py, pz);
    const bool seen = measured & (pz > 0);
    x[i] = seen ? within_bounds(px) : 0;
    y[i] = seen ? within_bounds(py) : 0;
    z[i] = seen ? within_bounds(pz) : PixelImage::no_depth;
    behind += (measured & !seen) ? 1 : 0;
  }
  return behind;
}

CLEAVE_MULTIVERSION
int split_packed_row(const float* p, std::size_t count, float* x, float* y, float* z) {
  return split_row(p, 3, count, x, y, z);
}

CLEAVE_MULTIVERSION
int split_aligned_row(const float* p, std::size_t count, float* x, float* y, float* z) {
  return split_row(p, 4, count, x, y, z);
}

}  // namespace

std::size_t load_row(const CloudView& cloud, std::uint32_t row, PixelImage& image) {
  const std::size_t begin = image.layout.row_begin(row);
  float* x = image.x.data() + begin;
  float* y = image.y.data() + begin;
  float* z = image.z.data() + begin;
  const float* p = cloud.point(std::size_t{row} * cloud.width);
  int behind = 0;
  if (cloud.stride == 3) {
    behind = split_packed_row(p, cloud.width, x, y, z);
  } else if (cloud.stride == 4) {
    behind = split_aligned_row(p, cloud.width, x, y, z);
  } else {
    behind = split_row(p, cloud.stride, cloud.width, x, y, z);
  }
  return static_cast<std::size_t>(behind);
}

}  // namespace cleave::segmentation
