// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "segmentation/math/multiversion.hpp"
#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::size_t samples = 128;
constexpr std::size_t reach = 8192;  // neighbours are looked for so many points before and behind

struct Points {
  const float *x, *y, *z;
  std::size_t count;
};

struct Nearest {
  float squared_m, squared_rad;
};

// Of the other points, not counting those in the same place. Angles are small: sine for angle.
CLEAVE_MULTIVERSION
void find_nearest(const Points& points, const Eigen::Vector3f& from, const Eigen::Vector3f& place,
                  Nearest& nearest) {
  constexpr float none = std::numeric_limits<float>::max();
  const float fx = from.x() - place.x(), fy = from.y() - place.y(), fz = from.z() - place.z();
  const float scale = 1 / (fx * fx + fy * fy + fz * fz);
  float least_m = none, least_rad = none;
  for (std::size_t i = 0; i < points.count; ++i) {
    const float dx = points.x[i] - from.x(), dy = points.y[i] - from.y(),
                dz = points.z[i] - from.z();
    const float squared_m = dx * dx + dy * dy + dz * dz;
    const float cx = fy * dz - fz * dy, cy = fz * dx - fx * dz, cz = fx * dy - fy * dx;
    const float qx = fx + dx, qy = fy + dy, qz = fz + dz;
    const float squared_rad = (cx * cx + cy * cy + cz * cz) * scale / (qx * qx + qy * qy + qz * qz);
    const bool other = squared_m > 0;
    least_m = other & (squared_m < least_m) ? squared_m : least_m;
    least_rad = other & (squared_rad < least_rad) ? squared_rad : least_rad;
  }
  nearest = {least_m, least_rad};
}

double quartile_ratio(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  const double low = values[values.size() / 4];
  const double high = values[values.size() * 3 / 4];
  return low > 0 ? high / low : std::numeric_limits<double>::max();
}

}  // namespace

void SightedPoints::find_middle(const CloudView& cloud) {
  constexpr std::size_t some = 1000;
  sample_.clear();
  const auto add_measured = [&](std::size_t i) {
    const float* p = cloud.point(i);
    if (is_measured(p)) sample_.emplace_back(p[0], p[1], p[2]);
  };
  for (std::size_t k = 0, n = std::min(some, cloud.size()); k < n; ++k) {
    add_measured((2 * k + 1) * cloud.size() / (2 * n));
  }
  for (std::size_t i = 0; i < cloud.size() && sample_.empty(); ++i) add_measured(i);
  middle_ = middle_finder_.find(sample_);
}

void SightedPoints::take(const CloudView& cloud) {
  for (auto* axis : {&x_, &y_, &z_}) axis->clear();
  find_middle(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float* p = cloud.point(i);
    if (!is_measured(p)) continue;
    const auto relative = [&](int axis) {
      return static_cast<float>(
          std::clamp(double{p[axis]} - middle_.place[axis], -farthest_m, farthest_m));
    };
    x_.push_back(relative(0));
    y_.push_back(relative(1));
    z_.push_back(relative(2));
  }
}

void SightedPoints::find_spacing(const Eigen::Vector3f& place, Sight& sight) {
  angular_.clear();
  metric_.clear();
  const std::size_t count = std::min(samples, size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (2 * k + 1) * size() / (2 * count);
    const std::size_t begin = i > reach ? i - reach : 0;
    const std::size_t end = std::min(size(), i + reach);
    Nearest nearest{};
    find_nearest({&x_[begin], &y_[begin], &z_[begin], end - begin}, {x_[i], y_[i], z_[i]}, place,
                 nearest);
    metric_.push_back(nearest.squared_m);
    angular_.push_back(nearest.squared_rad);
  }
  sight.metric_spread = quartile_ratio(metric_);
  sight.angular_spread = quartile_ratio(angular_);
  sight.spacing_rad = std::sqrt(angular_[angular_.size() / 2]);
}

double SightedPoints::share_hidden(const Eigen::Vector3d& place, double spacing_rad) {
  constexpr double spacings = 4;
  constexpr double least_bin = 1e-4, largest_bin = 0.1;
  constexpr double steepest = 6;  // surfaces seen at up to 80 deg hide nothing
  const double bin = std::clamp(spacings * spacing_rad, least_bin, largest_bin);
  const auto per_bin = static_cast<float>(1 / bin);
  const auto behind = static_cast<float>(1 + std::max(steepest * bin, 0.05));
  const Eigen::Vector3f relative = relative_to_middle(place);
  keys_.clear();
  range_.clear();
  for (std::size_t i = 0; i < size(); ++i) {
    const Eigen::Vector3f way = Eigen::Vector3f(x_[i], y_[i], z_[i]) - relative;
    const float range = way.norm();
    if (!(range > 0)) continue;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const float cell = std::floor((way[axis] / range + 1) * per_bin);
      key = (key << 20U) | static_cast<std::uint64_t>(std::clamp(cell, 0.0F, 1e6F));
    }
    keys_.push_back(key);
    range_.push_back(range);
  }
  if (keys_.empty()) return 0;
  ranking_.rank(keys_);
  nearest_.assign(ranking_.distinct_keys().size(), std::numeric_limits<float>::max());
  const auto& bin_of = ranking_.rank_of_item();
  for (std::size_t i = 0; i < range_.size(); ++i) {
    nearest_[bin_of[i]] = std::min(nearest_[bin_of[i]], range_[i]);
  }
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < range_.size(); ++i) {
    hidden += range_[i] > behind * nearest_[bin_of[i]] ? 1U : 0U;
  }
  return static_cast<double>(hidden) / static_cast<double>(range_.size());
}

Sight SightedPoints::look_from(const Eigen::Vector3d& place) {
  Sight sight;
  find_spacing(relative_to_middle(place), sight);
  return sight;
}

std::size_t SightedPoints::behind(const Eigen::Vector3d& place, const Eigen::Vector3d& axis) const {
  constexpr float least_cosine = 0.17F;
  const Eigen::Vector3f relative = relative_to_middle(place);
  const Eigen::Vector3f direction = axis.cast<float>();
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const Eigen::Vector3f way = Eigen::Vector3f(x_[i], y_[i], z_[i]) - relative;
    count += way.dot(direction) > least_cosine * way.norm() ? 0U : 1U;
  }
  return count;
}

}  // namespace cleave::segmentation
