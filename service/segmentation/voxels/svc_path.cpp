// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/svc_path.hpp"

#include <numeric>

namespace cleave::segmentation {

void SvcPath::cluster(const SupervoxelOptions& /*options*/, Supervoxels& supervoxels) {
  const std::vector<Surfel>& voxels = this->voxels();
  supervoxels.of_voxel.resize(voxels.size());
  std::iota(supervoxels.of_voxel.begin(), supervoxels.of_voxel.end(), 0U);
  supervoxels.surfel = voxels;
  supervoxels.point_count.resize(voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    supervoxels.point_count[v] = static_cast<std::uint32_t>(grid().moments[v].n);
  }
}

void SvcPath::build_graph(const Supervoxels& /*supervoxels*/, const Options& options,
                          std::vector<SupervoxelEdge>& edges) {
  normal_estimator().estimate_curvature(neighbours(), curvature_);
  voxel_graph_builder_.build(voxels(), curvature_, neighbours(), options.svc, edges);
}

}  // namespace cleave::segmentation
