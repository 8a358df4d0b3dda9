// SPDX-License-Identifier: BSD-3-Clause
// The steps of the segmentation on cells, the super-pixels of an image, where the cloud is one.
#pragma once

#include <span>
#include <vector>

#include "segmentation/cells/cell_adjacency.hpp"
#include "segmentation/cells/cell_clustering.hpp"
#include "segmentation/cells/cell_fragments.hpp"
#include "segmentation/cells/cell_image.hpp"
#include "segmentation/cells/cell_labels.hpp"
#include "segmentation/cells/cell_links.hpp"
#include "segmentation/cells/cell_normals.hpp"
#include "segmentation/cells/cell_supervoxels.hpp"
#include "segmentation/describe/surface.hpp"
#include "segmentation/options.hpp"
#include "segmentation/path/supervoxel_path.hpp"
#include "segmentation/points/mode_filter.hpp"
#include "segmentation/points/pixel_image.hpp"
#include "segmentation/points/point_runs.hpp"
#include "segmentation/spacing/cloud_spacing.hpp"

namespace cleave::segmentation {

class CellPath : public SupervoxelPath {
 public:
  // False if the cloud is not an image from one viewpoint: see CellImager.
  [[nodiscard]] bool gather(const CloudView& cloud, const VoxelOptions& options);

  [[nodiscard]] CloudSpacing spacing() const override;
  [[nodiscard]] bool seen_from_one_viewpoint() const override { return true; }
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
  // A patch an occupied cell, in the segment of the pixel in its middle.
  void list_surface(const std::vector<std::uint32_t>& segment_of_supervoxel,
                    Surface& surface) const override;

 private:
  CellImager imager_;
  CellNormalEstimator normal_estimator_;
  CellClusterer clusterer_;
  CellFragmentMender mender_;
  CellSupervoxelFitter fitter_;
  CellAdjacencyFinder adjacency_finder_;
  CellLabeller labeller_;
  ModeFilter mode_filter_;

  CellImage cells_;
  PixelImage pixels_;
  CellLinks links_;
  std::vector<std::uint32_t> owner_;
  std::vector<std::uint32_t> supervoxel_of_cell_;
  std::vector<AdjacentPair> adjacent_pairs_;
  std::vector<PixelSpan> mixed_;
  std::vector<PointRun> runs_;
};

}  // namespace cleave::segmentation
