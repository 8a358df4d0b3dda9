// SPDX-License-Identifier: BSD-3-Clause
// What is known of every segment, from its points.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "segmentation/describe/run_sums.hpp"
#include "segmentation/describe/surface.hpp"
#include "segmentation/math/moments.hpp"
#include "segmentation/options.hpp"
#include "segmentation/points/point_runs.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::segmentation {

class ShapeDescriber {
 public:
  // `label_of_segment`: canonical labels; 0 for what is no segment. `surface`: tells normals and
  // how boxes are turned; a segment that it lacks is judged by its points alone. `organised`:
  // whether runs have columns and rows.
  void describe(const SegmentedPoints& points, const Surface& surface, bool organised,
                const std::vector<std::uint16_t>& label_of_segment, const DescribeOptions& options,
                std::vector<Segment>& segments);

 private:
  struct Shape {
    RunMoments sums;
    RunExtent extent;
    std::uint32_t left = std::numeric_limits<std::uint32_t>::max(), right = 0;  // half-open columns
    std::uint32_t top = std::numeric_limits<std::uint32_t>::max(), bottom = 0;  // half-open rows
    Moments moments;
    Eigen::Vector3f normal_sum = Eigen::Vector3f::Zero();
    Eigen::Vector3f centroid = Eigen::Vector3f::Zero();
    Eigen::Matrix3f box_axes = Eigen::Matrix3f::Identity();
  };
  void sum_up(const SegmentedPoints& points, const std::vector<std::uint16_t>& label_of_segment);
  void group_surface(const Surface& surface, const std::vector<std::uint16_t>& label_of_segment);
  void aim(const Surface& surface, float plane_distance_m);
  void measure(const SegmentedPoints& points, const std::vector<std::uint16_t>& label_of_segment);

  std::vector<Shape> shapes_;                       // of label - 1
  std::vector<std::uint32_t> patch_begin_, patch_;  // patches by label
  std::vector<Surfel> sample_;
};

}  // namespace cleave::segmentation
