// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/camera/pixel_pitch.hpp"

#include <algorithm>
#include <cmath>

#include "segmentation/view/measured.hpp"
#include "segmentation/view/middle.hpp"

namespace cleave::segmentation {
namespace {

constexpr double odd = 4;  // times the mean, or back

bool is_in_front(const float* p) {
  return is_measured(p) && p[2] > 0;
}

template <class Visit>
void for_each_step(const CloudView& cloud, Visit&& visit) {
  constexpr std::uint32_t row_step = 8;
  for (std::uint32_t row = 0; row < cloud.height; row += row_step) {
    for (std::uint32_t column = 0; column + 1 < cloud.width; column += 2) {
      const float* p = cloud.point(std::size_t{row} * cloud.width + column);
      const float* q = p + cloud.stride;
      if (is_in_front(p) && is_in_front(q)) visit(double{q[0] / q[2] - p[0] / p[2]});
    }
  }
}

struct PitchSteps {
  double sum = 0, least = 0, most = 0;
  std::size_t count = 0;

  void add(double step) {
    sum += step;
    least = std::min(least, step);
    most = std::max(most, step);
    ++count;
  }
  [[nodiscard]] double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
};

}  // namespace

float PixelPitchFinder::find(const CloudView& cloud) {
  PitchSteps steps;
  for_each_step(cloud, [&](double step) { steps.add(step); });
  if (steps.least < 0 || !(steps.most < odd * steps.mean())) {
    steps_.clear();
    for_each_step(cloud, [&](double step) {
      if (std::isfinite(step)) steps_.push_back(step);
    });
    if (steps_.empty()) return 0;
    const double middle = median_of(steps_);
    steps = {};
    for (const double step : steps_) {
      if (step > 0 && step < odd * middle) steps.add(step);
    }
  }
  return static_cast<float>(steps.mean());
}

}  // namespace cleave::segmentation
