// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_path.hpp"

#include <algorithm>

namespace cleave::segmentation {

bool CellPath::gather(const CloudView& cloud, const VoxelOptions& options) {
  return imager_.gather(cloud, options.size_m, options.grid_offset, cells_, pixels_);
}

void CellPath::estimate_normals() {
  normal_estimator_.estimate(cells_);
  link_cells(cells_, links_);
}

void CellPath::cluster(const SupervoxelOptions& options, Supervoxels& supervoxels) {
  const std::uint32_t clusters = clusterer_.cluster(cells_, options, owner_);
  const std::uint32_t count =
      mender_.mend(cells_, links_, owner_, clusters, options, supervoxel_of_cell_);
  fitter_.fit(cells_, supervoxel_of_cell_, count, options.refit_from_points, supervoxels);
}

void CellPath::build_graph(const Supervoxels& supervoxels, const Options& options,
                           std::vector<SupervoxelEdge>& edges) {
  adjacency_finder_.find(cells_, links_, supervoxel_of_cell_, supervoxels.size(), adjacent_pairs_);
  build_supervoxel_graph(adjacent_pairs_, supervoxels.surfel, options.graph, edges);
}

void CellPath::label_points(const Supervoxels& supervoxels,
                            const std::vector<std::uint32_t>& segment_of_supervoxel,
                            const RefineOptions& options) {
  labeller_.label(cells_, supervoxel_of_cell_, supervoxels, segment_of_supervoxel, options.boundary,
                  pixels_);
  if (options.mode_filter_radius > 0) {
    labeller_.find_mixed_windows(cells_, options.mode_filter_radius, pixels_, mixed_);
    mode_filter_.filter(pixels_, mixed_, options.mode_filter_radius,
                        options.mode_filter_depth_gate_m);
  }
  list_runs(pixels_, runs_);
}

// Only points of cells' front layers count: few are behind.
CloudSpacing CellPath::spacing() const {
  double points = 0;
  double cells = 0;
  double inverse_depth = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!cells_.occupied(i)) continue;
    points += cells_.points[i];
    inverse_depth += cells_.inverse_depth[i];
    cells += 1;
  }
  return {.points = static_cast<std::size_t>(points),
          .points_a_cell = points / cells,
          .cell_m = cells_.pitch * cells / inverse_depth};
}

SegmentedPoints CellPath::points() const {
  return {pixels_.x.data(), pixels_.y.data(), pixels_.z.data(), &runs_};
}

void CellPath::write_labels(const std::vector<std::uint16_t>& label_of_segment,
                            std::span<std::uint16_t> labels) const {
  for (const PointRun& run : runs_) {
    const std::size_t row = std::size_t{run.row} * pixels_.layout.width;
    std::fill_n(labels.data() + row + run.left, run.right - run.left,
                label_of_segment[run.segment]);
  }
}

void CellPath::list_surface(const std::vector<std::uint32_t>& segment_of_supervoxel,
                            Surface& surface) const {
  surface.clear();
  const std::uint32_t middle = cells_.edge / 2;
  for (std::uint32_t row = 0; row < cells_.rows; ++row) {
    const std::size_t begin = cells_.row_begin(row);
    // Of the middle of the first cell. Where it is outside, it is in the border.
    const std::size_t pixel = pixels_.layout.row_begin(0) +
                              std::size_t{row * cells_.edge + middle} * pixels_.layout.stride -
                              std::size_t{cells_.shift_y} * pixels_.layout.stride - cells_.shift_x +
                              middle;
    for (std::uint32_t column = 0; column < cells_.columns; ++column) {
      const std::size_t i = begin + column;
      if (!cells_.occupied(i)) continue;
      std::uint32_t segment = pixels_.segment[pixel + std::size_t{column} * cells_.edge];
      if (segment == PixelImage::no_segment)
        segment = segment_of_supervoxel[supervoxel_of_cell_[i]];
      surface.add({{cells_.x[i], cells_.y[i], cells_.z[i]},
                   {cells_.normal_x[i], cells_.normal_y[i], cells_.normal_z[i]}},
                  segment, cells_.points[i]);
    }
  }
}

}  // namespace cleave::segmentation
