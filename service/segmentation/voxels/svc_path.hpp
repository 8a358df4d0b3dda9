// SPDX-License-Identifier: BSD-3-Clause
// Spectral Voxel Clustering (section 4.2): each voxel is a supervoxel, and neighbours are joined.
#pragma once

#include "segmentation/voxels/voxel_graph.hpp"
#include "segmentation/voxels/voxel_path.hpp"

namespace cleave::segmentation {

class SvcPath : public VoxelPath {
 public:
  void cluster(const SupervoxelOptions& options, Supervoxels& supervoxels) override;
  void build_graph(const Supervoxels& supervoxels, const Options& options,
                   std::vector<SupervoxelEdge>& edges) override;

 private:
  [[nodiscard]] Neighbourhood default_neighbourhood() const override {
    return Neighbourhood::edges;
  }

  VoxelGraphBuilder voxel_graph_builder_;
  std::vector<float> curvature_;
};

}  // namespace cleave::segmentation
