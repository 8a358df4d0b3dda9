// What is known of every segment, from its points.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/moments.hpp"
#include "segmentation/options.hpp"
#include "segmentation/point_set.hpp"
#include "segmentation/segmentation.hpp"
#include "segmentation/surfel.hpp"
#include "segmentation/voxel_grid.hpp"

namespace cleave::segmentation {

class ShapeDescriber {
 public:
  // `label_of_point`: canonical labels, 1 and up, of the point set. `voxels`: a surfel each.
  void describe(const CloudView& cloud, const PointSet& points, const VoxelGrid& grid,
                const std::vector<Surfel>& voxels, const std::vector<std::uint16_t>& label_of_point,
                const DescribeOptions& options, std::vector<Segment>& segments);

 private:
  struct Shape {
    Moments moments;
    Eigen::Vector3f normal_sum = Eigen::Vector3f::Zero();
    std::uint32_t left = std::numeric_limits<std::uint32_t>::max(),
                  right = 0;  // columns, inclusive
    std::uint32_t top = std::numeric_limits<std::uint32_t>::max(), bottom = 0;  // rows, inclusive
    Eigen::Vector3f centroid, plane_normal;
    Eigen::Matrix3f box_axes;
    Eigen::Vector3f low, high;  // limits along box_axes
    std::uint32_t points_on_plane = 0;
  };
  void sum_up(const PointSet& points, const VoxelGrid& grid, const std::vector<Surfel>& voxels,
              const std::vector<std::uint16_t>& label_of_point);
  void find_rectangles(const CloudView& cloud, const PointSet& points,
                       const std::vector<std::uint16_t>& label_of_point);
  void group_voxels(const VoxelGrid& grid, const std::vector<std::uint16_t>& label_of_point);
  void choose_axes(const std::vector<Surfel>& voxels);
  void measure(const PointSet& points, const std::vector<std::uint16_t>& label_of_point,
               float plane_distance_m);

  std::vector<Shape> shapes_;                       // of label - 1
  std::vector<std::uint16_t> label_of_voxel_;       // of one of its points
  std::vector<std::uint32_t> voxel_begin_, voxel_;  // voxels by label
  std::vector<Surfel> sample_;
};

}  // namespace cleave::segmentation
