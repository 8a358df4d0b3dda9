// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/voxel_path.hpp"

#include <algorithm>

namespace cleave::segmentation {

bool VoxelPath::gather(const CloudView& cloud, const VoxelOptions& options) {
  gather_measured_points(cloud, points_);
  const bool one_viewpoint = options.viewpoint != Viewpoint::multiple;
  if (one_viewpoint && points_.behind < points_.size()) drop_points_behind(points_);
  if (points_.size() == 0) return false;
  width_ = cloud.width;
  height_ = cloud.height;
  VoxelOptions voxel = options;
  if (voxel.neighbourhood == Neighbourhood::automatic) {
    voxel.neighbourhood = default_neighbourhood();
  }
  growth_ = voxel_fitter_.voxelise(points_, voxel, grid_, neighbours_);
  voxel_size_ = options.size_m * growth_;
  return true;
}

void VoxelPath::estimate_normals() {
  normal_estimator_.estimate(grid_.centroid, neighbours_, voxels_);
}

void VoxelPath::cluster(const SupervoxelOptions& options, Supervoxels& supervoxels) {
  const std::uint32_t count =
      clusterer_.cluster(voxels_, neighbours_, options, supervoxels.of_voxel);
  fitter_.fit(grid_, voxels_, count, options.refit_from_points, supervoxels);
}

void VoxelPath::build_graph(const Supervoxels& supervoxels, const Options& options,
                            std::vector<SupervoxelEdge>& edges) {
  adjacency_finder_.find(supervoxels.of_voxel, neighbours_, adjacent_pairs_);
  build_supervoxel_graph(adjacent_pairs_, supervoxels.surfel, options.graph, edges);
}

void VoxelPath::filter_image(const RefineOptions& options) {
  image_.lay_out({.width = width_,
                  .height = height_,
                  .shift_x = 0,
                  .stride = width_ + 2 * ImageLayout::border});
  std::fill(image_.z.begin(), image_.z.end(), PixelImage::no_depth);
  std::fill(image_.segment.begin(), image_.segment.end(), PixelImage::no_segment);
  const auto for_each_point = [&](auto&& work) {
    for (const PointRun& run : runs_) {
      const std::size_t row = image_.layout.row_begin(run.row) - std::size_t{run.row} * width_;
      for (std::size_t i = run.begin; i < run.end; ++i) work(i, row + points_.index[i]);
    }
  };
  list_runs(points_, segment_of_point_, width_, runs_);
  for_each_point([&](std::size_t point, std::size_t pixel) {
    image_.segment[pixel] = segment_of_point_[point];
    image_.z[pixel] = points_.z[point];
  });
  mixed_window_finder_.clear_marks(image_.layout.size());
  mixed_window_finder_.find({.edge = 1,
                             .shift_x = 0,
                             .shift_y = 0,
                             .columns = width_,
                             .rows = height_,
                             .stride = image_.layout.stride,
                             .first = image_.layout.row_begin(0)},
                            image_.segment, options.mode_filter_radius, image_.layout, mixed_);
  mode_filter_.filter(image_, mixed_, options.mode_filter_radius, options.mode_filter_depth_gate_m);
  for_each_point([&](std::size_t point, std::size_t pixel) {
    segment_of_point_[point] = image_.segment[pixel];
  });
}

void VoxelPath::label_points(const Supervoxels& supervoxels,
                             const std::vector<std::uint32_t>& segment_of_supervoxel,
                             const RefineOptions& options) {
  segment_of_point_.resize(points_.size());
  for (std::size_t run = 0; run < grid_.runs(); ++run) {
    const std::uint32_t supervoxel = supervoxels.of_voxel[grid_.run_voxel[run]];
    std::fill(segment_of_point_.begin() + grid_.run_begin[run],
              segment_of_point_.begin() + grid_.run_begin[run + 1],
              segment_of_supervoxel[supervoxel]);
  }
  if (options.boundary) {
    boundary_refiner_.refine(points_, grid_, neighbours_, supervoxels, segment_of_supervoxel,
                             segment_of_point_);
  }
  if (options.mode_filter_radius > 0 && height_ > 1) filter_image(options);
  list_runs(points_, segment_of_point_, width_, runs_);
}

CloudSpacing VoxelPath::spacing() const {
  double inverse_depth = 0;
  for (const Eigen::Vector3f& centroid : grid_.centroid) {
    inverse_depth += 1 / std::max(double{centroid.z()}, 1e-3);
  }
  const auto voxels = static_cast<double>(grid_.size());
  return {.points = points_.size(),
          .points_a_cell = static_cast<double>(points_.size()) / voxels,
          .cell_m = voxel_size_ * (grid_.one_viewpoint ? voxels / inverse_depth : 1),
          .growth = growth_};
}

SegmentedPoints VoxelPath::points() const {
  return {points_.x.data(), points_.y.data(), points_.z.data(), &runs_};
}

void VoxelPath::write_labels(const std::vector<std::uint16_t>& label_of_segment,
                             std::span<std::uint16_t> labels) const {
  for (const PointRun& run : runs_) {
    for (std::size_t i = run.begin; i < run.end; ++i) {
      labels[points_.index[i]] = label_of_segment[run.segment];
    }
  }
}

void VoxelPath::list_surface(const std::vector<std::uint32_t>& /*segment_of_supervoxel*/,
                             Surface& surface) const {
  surface.clear();
  for (std::size_t v = 0; v < grid_.size(); ++v) {
    surface.add(voxels_[v], 0, static_cast<float>(grid_.moments[v].n));
  }
  for (std::size_t run = 0; run < grid_.runs(); ++run) {
    surface.segment[grid_.run_voxel[run]] = segment_of_point_[grid_.run_begin[run]];
  }
}

}  // namespace cleave::segmentation
