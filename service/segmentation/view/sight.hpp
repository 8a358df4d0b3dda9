// SPDX-License-Identifier: BSD-3-Clause
// How the points of a cloud look from some place: tells whether a sensor stood there.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/view/middle.hpp"

namespace cleave::segmentation {

struct Sight {
  // How much the distances from points to their nearest neighbours differ: upper over lower
  // quartile, squared. In angles even means sampled by a sensor there; in metres, by a voxel
  // filter.
  double angular_spread = 1, metric_spread = 1;
  double spacing_rad = 0;  // median
};

// The measured points of a cloud, relative to their middle.
class SightedPoints {
 public:
  void take(const CloudView& cloud);
  [[nodiscard]] std::size_t size() const { return x_.size(); }
  // Of a thousand points, in the coordinates of the cloud.
  [[nodiscard]] const Eigen::Vector3d& middle() const { return middle_.place; }
  [[nodiscard]] double extent_m() const { return middle_.extent_m; }

  // From `place`, in the coordinates of the cloud. Not empty.
  [[nodiscard]] Sight look_from(const Eigen::Vector3d& place);
  // Share of points behind others, of which a sensor in `place` would see none. `spacing_rad` is
  // that of the points as seen from there. Looks at every point.
  [[nodiscard]] double share_hidden(const Eigen::Vector3d& place, double spacing_rad);
  // How many points are not seen from `place` at less than about 80 deg from `axis`, a unit vector.
  [[nodiscard]] std::size_t behind(const Eigen::Vector3d& place, const Eigen::Vector3d& axis) const;

 private:
  void find_middle(const CloudView& cloud);
  void find_spacing(const Eigen::Vector3f& place, Sight& sight);
  [[nodiscard]] Eigen::Vector3f relative_to_middle(const Eigen::Vector3d& place) const {
    return (place - middle_.place).cast<float>();
  }

  Middle middle_;
  MiddleFinder middle_finder_;
  std::vector<float> x_, y_, z_;
  std::vector<Eigen::Vector3d> sample_;
  std::vector<double> angular_, metric_;
  std::vector<std::uint64_t> keys_;
  std::vector<float> range_, nearest_;
  CellRanking ranking_;
};

}  // namespace cleave::segmentation
