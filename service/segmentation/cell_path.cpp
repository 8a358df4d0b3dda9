#include "segmentation/cell_path.hpp"

namespace cleave::segmentation {

bool CellPath::gather(const CloudView& cloud, const VoxelOptions& options) {
  return imager_.gather(cloud, options.size_m, options.grid_offset, cells_, image_.depth_m);
}

void CellPath::estimate_normals() {
  normal_estimator_.estimate(cells_);
  link_cells(cells_, links_);
}

void CellPath::cluster(const SupervoxelOptions& options, Supervoxels& supervoxels) {
  const std::uint32_t clusters = clusterer_.cluster(cells_, options, owner_);
  const std::uint32_t count =
      mender_.mend(cells_, links_, owner_, clusters, options, supervoxel_of_cell_);
  fitter_.fit(cells_, supervoxel_of_cell_, count, supervoxels);
}

void CellPath::find_adjacent_pairs(std::vector<AdjacentPair>& pairs) {
  adjacency_finder_.find(cells_, links_, supervoxel_of_cell_, pairs);
}

void CellPath::label_points(const CloudView& cloud, const Supervoxels& supervoxels,
                            const std::vector<std::uint32_t>& segment_of_supervoxel,
                            const RefineOptions& options) {
  labeller_.label(cloud, cells_, supervoxel_of_cell_, supervoxels, segment_of_supervoxel,
                  options.boundary, image_);
  if (options.mode_filter_radius > 0) {
    mode_filter_.filter(image_, options.mode_filter_radius, options.mode_filter_depth_gate_m);
  }
}

void CellPath::list_as_voxels(const PointSet& points, VoxelGrid& grid,
                              std::vector<Surfel>& voxels) {
  voxels.clear();
  voxel_of_cell_.resize(cells_.size());
  for (std::uint32_t row = 0; row < cells_.rows; ++row) {
    const std::size_t begin = cells_.row_begin(row);
    for (std::size_t i = begin; i < begin + cells_.columns; ++i) {
      if (!cells_.occupied(i)) continue;
      voxel_of_cell_[i] = static_cast<std::uint32_t>(voxels.size());
      voxels.push_back({{cells_.x[i], cells_.y[i], cells_.z[i]},
                        {cells_.normal_x[i], cells_.normal_y[i], cells_.normal_z[i]}});
    }
  }

  grid.key.resize(voxels.size());  // VoxelGrid::size()
  grid.run_begin.clear();
  grid.run_voxel.clear();
  cell_of_column_.resize(image_.width);
  for (std::uint32_t column = 0; column < image_.width; ++column) {
    cell_of_column_[column] = (column + cells_.shift_x) / cells_.edge;
  }
  std::uint32_t row = 0;
  std::uint32_t row_begin = 0;
  std::size_t cells_begin = cells_.row_begin(cells_.shift_y / cells_.edge);
  std::size_t last_cell = CellImage::no_cell;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    while (points.index[p] - row_begin >= image_.width) {
      row_begin += image_.width;
      cells_begin = cells_.row_begin((++row + cells_.shift_y) / cells_.edge);
      last_cell = CellImage::no_cell;
    }
    const std::size_t cell = cells_begin + cell_of_column_[points.index[p] - row_begin];
    if (cell == last_cell) continue;
    last_cell = cell;
    grid.run_begin.push_back(p);
    grid.run_voxel.push_back(voxel_of_cell_[cell]);
  }
  grid.run_begin.push_back(static_cast<std::uint32_t>(points.size()));
}

}  // namespace cleave::segmentation
