// SPDX-License-Identifier: BSD-3-Clause
// The steps of the segmentation on voxels, for any cloud.
#pragma once

#include <span>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/describe/surface.hpp"
#include "segmentation/graph/adjacency.hpp"
#include "segmentation/options.hpp"
#include "segmentation/path/supervoxel_path.hpp"
#include "segmentation/points/mode_filter.hpp"
#include "segmentation/points/point_runs.hpp"
#include "segmentation/points/point_set.hpp"
#include "segmentation/spacing/cloud_spacing.hpp"
#include "segmentation/voxels/boundary_refinement.hpp"
#include "segmentation/voxels/normals.hpp"
#include "segmentation/voxels/supervoxel_clustering.hpp"
#include "segmentation/voxels/supervoxel_fitter.hpp"
#include "segmentation/voxels/voxel_fitter.hpp"
#include "segmentation/voxels/voxel_grid.hpp"

namespace cleave::segmentation {

class VoxelPath : public SupervoxelPath {
 public:
  // False if no point was measured. Seen from one viewpoint, points on or behind the sensor's plane
  // are left out, unless all are: no sensor in the origin measured them.
  [[nodiscard]] bool gather(const CloudView& cloud, const VoxelOptions& options);

  [[nodiscard]] CloudSpacing spacing() const override;
  [[nodiscard]] bool seen_from_one_viewpoint() const override { return grid_.one_viewpoint; }
  void estimate_normals() override;
  void cluster(const SupervoxelOptions& options, Supervoxels& supervoxels) override;
  void build_graph(const Supervoxels& supervoxels, const Options& options,
                   std::vector<SupervoxelEdge>& edges) override;
  void label_points(const Supervoxels& supervoxels,
                    const std::vector<std::uint32_t>& segment_of_supervoxel,
                    const RefineOptions& options) override;
  [[nodiscard]] SegmentedPoints points() const override;
  void write_labels(const std::vector<std::uint16_t>& label_of_segment,
                    std::span<std::uint16_t> labels) const override;
  // A patch a voxel, in the segment of one of its points.
  void list_surface(const std::vector<std::uint32_t>& segment_of_supervoxel,
                    Surface& surface) const override;

 protected:
  [[nodiscard]] const VoxelGrid& grid() const { return grid_; }
  [[nodiscard]] const NeighbourLists& neighbours() const { return neighbours_; }
  [[nodiscard]] const std::vector<Surfel>& voxels() const { return voxels_; }
  [[nodiscard]] NormalEstimator& normal_estimator() { return normal_estimator_; }

 private:
  // What Neighbourhood::automatic is.
  [[nodiscard]] virtual Neighbourhood default_neighbourhood() const {
    return Neighbourhood::corners;
  }
  void filter_image(const RefineOptions& options);

  VoxelFitter voxel_fitter_;
  NormalEstimator normal_estimator_;
  SupervoxelClusterer clusterer_;
  SupervoxelFitter fitter_;
  AdjacencyFinder adjacency_finder_;
  BoundaryRefiner boundary_refiner_;
  MixedWindowFinder mixed_window_finder_;
  ModeFilter mode_filter_;

  std::uint32_t width_ = 0;   // of the cloud
  std::uint32_t height_ = 0;  // 1: no image
  float growth_ = 1;
  float voxel_size_ = 0;
  PointSet points_;
  VoxelGrid grid_;
  NeighbourLists neighbours_;   // of voxels
  std::vector<Surfel> voxels_;  // of the grid
  std::vector<AdjacentPair> adjacent_pairs_;
  std::vector<std::uint32_t> segment_of_point_;
  std::vector<PointRun> runs_;
  PixelImage image_;  // depths and segments only
  std::vector<PixelSpan> mixed_;
};

}  // namespace cleave::segmentation
