// The steps of the segmentation on voxels, for any cloud.
#pragma once

#include <span>
#include <vector>

#include "segmentation/adjacency.hpp"
#include "segmentation/boundary_refinement.hpp"
#include "segmentation/cloud_view.hpp"
#include "segmentation/mode_filter.hpp"
#include "segmentation/normals.hpp"
#include "segmentation/options.hpp"
#include "segmentation/point_runs.hpp"
#include "segmentation/point_set.hpp"
#include "segmentation/spacing/cloud_spacing.hpp"
#include "segmentation/spacing/voxel_fitter.hpp"
#include "segmentation/supervoxel_clustering.hpp"
#include "segmentation/supervoxels.hpp"
#include "segmentation/surface.hpp"
#include "segmentation/voxel_graph.hpp"
#include "segmentation/voxel_grid.hpp"

namespace cleave::segmentation {

// Each step needs those before it.
class VoxelPath {
 public:
  // False if no point was measured. Seen from one viewpoint, points on or behind the sensor's plane
  // are left out, unless all are: no sensor in the origin measured them.
  [[nodiscard]] bool gather(const CloudView& cloud, const VoxelOptions& options);
  [[nodiscard]] bool seen_from_one_viewpoint() const { return grid_.one_viewpoint; }
  [[nodiscard]] CloudSpacing spacing() const;
  void estimate_normals();
  void cluster(const SupervoxelOptions& options, Supervoxels& supervoxels);
  // For Spectral Voxel Clustering, instead of cluster() and a graph of supervoxels: each voxel is
  // one, and neighbours are joined.
  void take_voxels_as_supervoxels(Supervoxels& supervoxels) const;
  void build_voxel_graph(const SvcOptions& options, std::vector<SupervoxelEdge>& edges);
  void find_adjacent_pairs(const Supervoxels& supervoxels, std::vector<AdjacentPair>& pairs);
  void label_points(const CloudView& cloud, const Supervoxels& supervoxels,
                    const std::vector<std::uint32_t>& segment_of_supervoxel,
                    const RefineOptions& options);

  [[nodiscard]] SegmentedPoints points() const;
  // Labels by the cloud's points; those of points that were not measured are left alone.
  void write_labels(const std::vector<std::uint16_t>& label_of_segment,
                    std::span<std::uint16_t> labels) const;
  // A patch a voxel, in the segment of one of its points.
  void list_surface(Surface& surface) const;

 private:
  void filter_image(const CloudView& cloud, const RefineOptions& options);

  VoxelFitter voxel_fitter_;
  NormalEstimator normal_estimator_;
  SupervoxelClusterer clusterer_;
  VoxelGraphBuilder voxel_graph_builder_;
  SupervoxelFitter fitter_;
  AdjacencyFinder adjacency_finder_;
  BoundaryRefiner boundary_refiner_;
  MixedWindowFinder mixed_window_finder_;
  ModeFilter mode_filter_;

  float growth_ = 1;
  float voxel_size_ = 0;
  PointSet points_;
  VoxelGrid grid_;
  NeighbourLists neighbours_;   // of voxels
  std::vector<Surfel> voxels_;  // of the grid
  std::vector<float> curvature_;
  std::vector<std::uint32_t> segment_of_point_;
  std::vector<PointRun> runs_;
  PixelImage image_;  // depths and segments only
  std::vector<PixelSpan> mixed_;
};

}  // namespace cleave::segmentation
