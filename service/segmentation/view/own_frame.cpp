// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/own_frame.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "segmentation/view/middle.hpp"

namespace cleave::segmentation {
namespace {

constexpr double most = 0.98;         // of the pixels
constexpr double nearly_all = 0.995;  // of the points are in front
constexpr double hit_px = 1;
constexpr double max_lean = 0.2;  // of the image's axes against x and y, tangent
constexpr std::size_t min_fit_pixels = 12;

}  // namespace

bool OwnFrameFinder::fit() {
  mean_at_ = mean_sight_ = Eigen::Vector2d::Zero();
  for (const Pixel& p : kept_) {
    mean_at_ += p.at;
    mean_sight_ += p.sight;
  }
  const auto count = static_cast<double>(kept_.size());
  mean_at_ /= count;
  mean_sight_ /= count;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d both = Eigen::Matrix2d::Zero();
  for (const Pixel& p : kept_) {
    const Eigen::Vector2d at = p.at - mean_at_;
    spread += at * at.transpose();
    both += (p.sight - mean_sight_) * at.transpose();
  }
  constexpr double on_a_line = 1e-6;
  if (!(spread.determinant() > on_a_line * spread.trace() * spread.trace())) return false;
  pitch_ = both * spread.inverse();
  constexpr double no_pitch = 1e-9;
  return pitch_.row(0).norm() > no_pitch && pitch_.row(1).norm() > no_pitch;
}

double OwnFrameFinder::squared_miss_px(const Pixel& pixel) const {
  const Eigen::Vector2d miss =
      pixel.sight - mean_sight_ - pitch_ * Eigen::Vector2d(pixel.at - mean_at_);
  return miss.x() * miss.x() / pitch_.row(0).squaredNorm() +
         miss.y() * miss.y() / pitch_.row(1).squaredNorm();
}

double OwnFrameFinder::share_hit() const {
  const auto hits = std::count_if(all_.begin(), all_.end(), [this](const Pixel& p) {
    return squared_miss_px(p) <= hit_px * hit_px;
  });
  return static_cast<double>(hits) / static_cast<double>(all_.size());
}

void OwnFrameFinder::drop_strays() {
  constexpr double far = 9;  // times the median, squared
  constexpr double least = 1e-6;
  misses_.clear();
  for (const Pixel& p : all_) misses_.push_back(squared_miss_px(p));
  const double limit = far * std::max(median_of(misses_), least);
  kept_.clear();
  for (const Pixel& p : all_) {
    if (squared_miss_px(p) <= limit) kept_.push_back(p);
  }
}

std::optional<OwnFrame> OwnFrameFinder::find(const std::vector<SampledPixel>& pixels) {
  constexpr int rounds = 4;
  static constexpr double aside = 1e6;  // farther than that is as far
  const auto slope = [](double across, double z) { return std::clamp(across / z, -aside, aside); };
  all_.clear();
  for (const SampledPixel& p : pixels) {
    if (!(p.point.z() > 0)) continue;
    all_.push_back(
        {{p.column, p.row}, {slope(p.point.x(), p.point.z()), slope(p.point.y(), p.point.z())}});
  }
  if (all_.size() < min_fit_pixels ||
      static_cast<double>(all_.size()) < nearly_all * static_cast<double>(pixels.size())) {
    return std::nullopt;
  }
  kept_ = all_;
  double share = 0;
  for (int round = 0; round < rounds; ++round) {
    if (kept_.size() < min_fit_pixels || !fit()) return std::nullopt;
    share = share_hit();
    if (share >= most) break;
    drop_strays();
  }
  const double a = std::abs(pitch_(0, 0)), b = std::abs(pitch_(0, 1));
  const double c = std::abs(pitch_(1, 0)), d = std::abs(pitch_(1, 1));
  const bool along = b <= max_lean * a && c <= max_lean * d;
  const bool across = a <= max_lean * b && d <= max_lean * c;
  if (!along && !across) return std::nullopt;
  return OwnFrame{.order = {.transposed = across,
                            .columns_reversed = (across ? pitch_(1, 0) : pitch_(0, 0)) < 0,
                            .rows_reversed = (across ? pitch_(0, 1) : pitch_(1, 1)) < 0},
                  .exact = share >= most};
}

}  // namespace cleave::segmentation
