// SPDX-License-Identifier: BSD-3-Clause
#include "recording/units/nearest_spacing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "recording/percentile.hpp"

namespace cleave::recording {
namespace {

constexpr std::size_t queries = 1000;
constexpr std::uint32_t crowded = 5000;  // points in three buckets

// Buckets of about a point each, over what most points lie in; strays count to the outermost.
class Buckets {
 public:
  explicit Buckets(const std::vector<PlanePoint>& points) : points_(points) {
    find_extent();
    begin_.assign(columns_ * rows_ + 1, 0);
    for (const PlanePoint& p : points) ++begin_[bucket_of(p)];
    std::uint32_t end = 0;
    for (std::uint32_t& bucket : begin_) bucket = end += bucket;
    order_.resize(points.size());
    for (auto i = static_cast<std::uint32_t>(points.size()); i-- > 0;) {
      order_[--begin_[bucket_of(points[i])]] = i;
    }
  }

  // Infinite if there is none in the buckets around, or too many to look at.
  [[nodiscard]] double nearest_to(const PlanePoint& p) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    double least = none;
    const std::size_t column = place(p.x, low_.x, columns_);
    const std::size_t row = place(p.y, low_.y, rows_);
    for (std::size_t r = row - std::min<std::size_t>(row, 1); r <= row + 1 && r < rows_; ++r) {
      const std::size_t first = r * columns_ + column - std::min<std::size_t>(column, 1);
      const std::size_t last = r * columns_ + std::min(column + 1, columns_ - 1);
      if (begin_[last + 1] - begin_[first] > crowded) return none;
      for (std::uint32_t k = begin_[first]; k < begin_[last + 1]; ++k) {
        const double dx = double{points_[order_[k]].x} - double{p.x};
        const double dy = double{points_[order_[k]].y} - double{p.y};
        const double squared = dx * dx + dy * dy;
        if (squared > 0) least = std::min(least, squared);
      }
    }
    return std::sqrt(least);
  }

 private:
  void find_extent() {
    std::array<std::vector<double>, 2> sample;
    const std::size_t step = points_.size() / queries + 1;
    for (std::size_t i = 0; i < points_.size(); i += step) {
      sample[0].push_back(points_[i].x);
      sample[1].push_back(points_[i].y);
    }
    low_ = {static_cast<float>(percentile(sample[0], 0.01)),
            static_cast<float>(percentile(sample[1], 0.01))};
    const double width = percentile(sample[0], 0.99) - double{low_.x};
    const double height = percentile(sample[1], 0.99) - double{low_.y};
    const double area = width * height;
    if (!(area > 0)) return;  // a line: one bucket
    edge_ = std::sqrt(area / static_cast<double>(points_.size()));
    const auto most = static_cast<double>(points_.size());
    columns_ = static_cast<std::size_t>(std::clamp(width / edge_, 1.0, most));
    rows_ = static_cast<std::size_t>(std::clamp(height / edge_, 1.0, most));
  }

  [[nodiscard]] std::size_t place(float value, float low, std::size_t count) const {
    const double at = (double{value} - double{low}) / edge_;
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
  }
  [[nodiscard]] std::size_t bucket_of(const PlanePoint& p) const {
    return place(p.y, low_.y, rows_) * columns_ + place(p.x, low_.x, columns_);
  }

  const std::vector<PlanePoint>& points_;
  PlanePoint low_;
  double edge_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> begin_, order_;  // points by bucket
};

}  // namespace

NearestSpacing nearest_spacing(const std::vector<PlanePoint>& points) {
  if (points.size() < 2) return {};
  const Buckets buckets(points);
  std::vector<double> distances;
  const std::size_t step = points.size() / queries + 1;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const double distance = buckets.nearest_to(points[i]);
    if (std::isfinite(distance)) distances.push_back(distance);
  }
  if (distances.empty()) return {};
  return {.median = percentile(distances, 0.5),
          .spread = percentile(distances, 0.9) / percentile(distances, 0.1)};
}

}  // namespace cleave::recording
