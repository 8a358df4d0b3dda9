// The steps of the segmentation on cells of an image, where the cloud is one.
#pragma once

#include <span>
#include <vector>

#include "segmentation/cell_adjacency.hpp"
#include "segmentation/cell_clustering.hpp"
#include "segmentation/cell_fragments.hpp"
#include "segmentation/cell_image.hpp"
#include "segmentation/cell_labels.hpp"
#include "segmentation/cell_links.hpp"
#include "segmentation/cell_normals.hpp"
#include "segmentation/cell_supervoxels.hpp"
#include "segmentation/mode_filter.hpp"
#include "segmentation/options.hpp"
#include "segmentation/pixel_image.hpp"
#include "segmentation/point_runs.hpp"
#include "segmentation/spacing/cloud_spacing.hpp"
#include "segmentation/surface.hpp"

namespace cleave::segmentation {

// The same steps as on voxels, in the same order; each needs those before it.
class CellPath {
 public:
  // False if the cloud is not an image from one viewpoint: see CellImager.
  [[nodiscard]] bool gather(const CloudView& cloud, const VoxelOptions& options);
  [[nodiscard]] CloudSpacing spacing() const;
  void estimate_normals();
  void cluster(const SupervoxelOptions& options, Supervoxels& supervoxels);
  void find_adjacent_pairs(const Supervoxels& supervoxels, std::vector<AdjacentPair>& pairs);
  void label_points(const Supervoxels& supervoxels,
                    const std::vector<std::uint32_t>& segment_of_supervoxel,
                    const RefineOptions& options);

  [[nodiscard]] SegmentedPoints points() const;
  // Labels by the cloud's points; those of points that were not measured are left alone.
  void write_labels(const std::vector<std::uint16_t>& label_of_segment,
                    std::span<std::uint16_t> labels) const;
  // A patch an occupied cell, in the segment of the pixel in its middle.
  void list_surface(const std::vector<std::uint32_t>& segment_of_supervoxel,
                    Surface& surface) const;

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
  std::vector<PixelSpan> mixed_;
  std::vector<PointRun> runs_;
};

}  // namespace cleave::segmentation
