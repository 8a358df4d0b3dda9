// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleave::workbench {
namespace {

using evaluation::LabelledCloud;

void append(const LabelledCloud& from, std::size_t i, LabelledCloud& to) {
  to.xyz.insert(to.xyz.end(), &from.xyz[3 * i], &from.xyz[3 * i] + 3);
  if (from.labelled()) to.label.push_back(from.label[i]);
}

bool is_one_surface(float z_m, float other_m) {
  constexpr float largest_step = 0.03F;
  return std::abs(z_m - other_m) < largest_step * std::abs(z_m);
}

// The pixel half a step right of and below `i`, as far as `right` and `below` say so: the mean of
// the pixels around it that lie on the surface of `i`.
void append_between(const LabelledCloud& from, std::size_t i, std::size_t right, std::size_t below,
                    LabelledCloud& to) {
  const std::array around = {i, i + right, i + below, i + right + below};
  std::array<float, 3> sum = {0, 0, 0};
  float count = 0;
  for (const std::size_t k : around) {
    if (k != i && !is_one_surface(from.xyz[3 * i + 2], from.xyz[3 * k + 2])) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += from.xyz[3 * k + axis];
    ++count;
  }
  for (const float value : sum) to.xyz.push_back(value / count);
  if (from.labelled()) to.label.push_back(from.label[i]);
}

LabelledCloud quadruple_image(const LabelledCloud& cloud) {
  LabelledCloud result{
      .width = 2 * cloud.width, .height = 2 * cloud.height, .xyz = {}, .label = {}};
  for (std::uint32_t row = 0; row < result.height; ++row) {
    for (std::uint32_t column = 0; column < result.width; ++column) {
      const std::uint32_t x = column / 2;
      const std::uint32_t y = row / 2;
      const std::size_t right = column % 2 == 1 && x + 1 < cloud.width ? 1 : 0;
      const std::size_t below = row % 2 == 1 && y + 1 < cloud.height ? cloud.width : 0;
      append_between(cloud, std::size_t{y} * cloud.width + x, right, below, result);
    }
  }
  return result;
}

LabelledCloud quadruple_points(const LabelledCloud& cloud) {
  constexpr float step_m = 0.0005F;
  LabelledCloud result{.width = 4 * cloud.width, .height = 1, .xyz = {}, .label = {}};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (const float shift_m : {0.0F, step_m, -step_m, 1.5F * step_m}) {
      append(cloud, i, result);
      result.xyz[result.xyz.size() - 3] += shift_m;
    }
  }
  return result;
}

}  // namespace

LabelledCloud quarter(const LabelledCloud& cloud) {
  const bool image = cloud.view().organised();
  const std::uint32_t step = image ? 2 : 4;
  LabelledCloud result{.width = std::max(1U, cloud.width / step),
                       .height = image ? cloud.height / 2 : 1,
                       .xyz = {},
                       .label = {}};
  for (std::uint32_t row = 0; row < result.height; ++row) {
    for (std::uint32_t column = 0; column < result.width; ++column) {
      append(cloud, std::size_t{row} * 2 * cloud.width + std::size_t{column} * step, result);
    }
  }
  return result;
}

LabelledCloud quadruple(const LabelledCloud& cloud) {
  return cloud.view().organised() ? quadruple_image(cloud) : quadruple_points(cloud);
}

}  // namespace cleave::workbench
