// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/nearest_label.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "segmentation/view/measured.hpp"

namespace cleave::evaluation {
namespace {

constexpr float cell_m = 0.02F;
constexpr float farthest = 1e8F;  // cells: beyond, all are one

using Cell = std::tuple<int, int, int>;

// The labelled points, by cell of a coarse grid.
class LabelledPoints {
 public:
  explicit LabelledPoints(const segmentation::CloudView& cloud) : cloud_(cloud) {}

  void add(std::size_t point) {
    const Eigen::Vector3i cell = cell_of(point);
    low_ = low_.cwiseMin(cell);
    high_ = high_.cwiseMax(cell);
    points_[{cell.x(), cell.y(), cell.z()}].push_back(point);
  }
  [[nodiscard]] bool empty() const { return points_.empty(); }

  // Looks at cells in shells around the point's own: what lies in shell r is at least r - 1 cells
  // away. A shell with more cells than there are is not worth it.
  [[nodiscard]] std::size_t nearest(std::size_t point) const {
    const Eigen::Vector3i centre = cell_of(point);
    Best best;
    for (int r = first_shell(centre); best.distance_m > static_cast<float>(r - 1) * cell_m; ++r) {
      const double cells_of_shell = 24.0 * r * r;
      if (cells_of_shell > static_cast<double>(points_.size())) {
        for (const auto& [cell, points] : points_) look_at(point, points, best);
        break;
      }
      look_at_shell(point, centre, r, best);
    }
    return best.point;
  }

 private:
  struct Best {
    float distance_m = std::numeric_limits<float>::infinity();
    std::size_t point = 0;
  };

  [[nodiscard]] Eigen::Vector3f position(std::size_t point) const {
    return Eigen::Map<const Eigen::Vector3f>(cloud_.point(point));
  }
  [[nodiscard]] Eigen::Vector3i cell_of(std::size_t point) const {
    return (position(point) / cell_m)
        .array()
        .floor()
        .cwiseMin(farthest)
        .cwiseMax(-farthest)
        .cast<int>();
  }
  // No cell before this shell can hold a point.
  [[nodiscard]] int first_shell(const Eigen::Vector3i& centre) const {
    return std::max({0, (low_ - centre).maxCoeff(), (centre - high_).maxCoeff()});
  }
  void look_at_shell(std::size_t point, const Eigen::Vector3i& centre, int r, Best& best) const {
    for (int dx = -r; dx <= r; ++dx) {
      for (int dy = -r; dy <= r; ++dy) {
        const bool face = std::abs(dx) == r || std::abs(dy) == r;
        for (int dz = -r; dz <= r; dz += face || r == 0 ? 1 : 2 * r) {
          look_at_cell(point, {centre.x() + dx, centre.y() + dy, centre.z() + dz}, best);
        }
      }
    }
  }
  void look_at_cell(std::size_t point, const Cell& cell, Best& best) const {
    const auto found = points_.find(cell);
    if (found != points_.end()) look_at(point, found->second, best);
  }
  void look_at(std::size_t point, const std::vector<std::size_t>& others, Best& best) const {
    for (const std::size_t other : others) {
      const float distance_m = (position(other) - position(point)).norm();
      if (std::tie(distance_m, other) < std::tie(best.distance_m, best.point)) {
        best = {distance_m, other};
      }
    }
  }

  segmentation::CloudView cloud_;
  std::map<Cell, std::vector<std::size_t>> points_;
  Eigen::Vector3i low_ = Eigen::Vector3i::Constant(std::numeric_limits<int>::max() / 2);
  Eigen::Vector3i high_ = Eigen::Vector3i::Constant(std::numeric_limits<int>::min() / 2);
};

}  // namespace

void label_unlabelled(const segmentation::CloudView& cloud, std::span<std::uint16_t> labels) {
  LabelledPoints labelled(cloud);
  std::vector<std::size_t> unlabelled;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (segmentation::is_measured(cloud.point(i)) && labels[i] == 0) unlabelled.push_back(i);
  }
  if (unlabelled.empty()) return;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (segmentation::is_measured(cloud.point(i)) && labels[i] != 0) labelled.add(i);
  }
  if (labelled.empty()) return;

  std::vector<std::uint16_t> taken;
  taken.reserve(unlabelled.size());
  for (const std::size_t i : unlabelled) taken.push_back(labels[labelled.nearest(i)]);
  for (std::size_t k = 0; k < unlabelled.size(); ++k) labels[unlabelled[k]] = taken[k];
}

}  // namespace cleave::evaluation
