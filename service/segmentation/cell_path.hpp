// The steps of the segmentation on cells of an image, where the cloud is one.
#pragma once

#include <vector>

#include "segmentation/cell_adjacency.hpp"
#include "segmentation/cell_clustering.hpp"
#include "segmentation/cell_fragments.hpp"
#include "segmentation/cell_image.hpp"
#include "segmentation/cell_labels.hpp"
#include "segmentation/cell_links.hpp"
#include "segmentation/cell_normals.hpp"
#include "segmentation/cell_supervoxels.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// The same steps as on voxels, in the same order; each needs those before it.
class CellPath {
 public:
  // False if the cloud is not an image from one viewpoint: see CellImager.
  [[nodiscard]] bool gather(const CloudView& cloud, const VoxelOptions& options);
  void estimate_normals();
  void cluster(const SupervoxelOptions& options, Supervoxels& supervoxels);
  void find_adjacent_pairs(std::vector<AdjacentPair>& pairs);
  void label_points(const CloudView& cloud, const Supervoxels& supervoxels,
                    const std::vector<std::uint32_t>& segment_of_supervoxel,
                    const RefineOptions& options);

  // Segment of every pixel.
  [[nodiscard]] const SegmentImage& image() const { return image_; }
  // The occupied cells as a grid's voxels, for what works on either.
  void list_as_voxels(const PointSet& points, VoxelGrid& grid, std::vector<Surfel>& voxels);

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
  SegmentImage image_;
  CellLinks links_;
  std::vector<std::uint32_t> owner_;
  std::vector<std::uint32_t> supervoxel_of_cell_;
  std::vector<std::uint32_t> voxel_of_cell_, cell_of_column_;
};

}  // namespace cleave::segmentation
