// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/voxel_partition.hpp"

namespace cleave::segmentation {

std::uint32_t VoxelPartitioner::partition(std::uint32_t voxels,
                                          const std::vector<SupervoxelEdge>& edges,
                                          const Options& options,
                                          std::vector<std::uint32_t>& segment) {
  cut_edges_.clear();
  for (const SupervoxelEdge& edge : edges) {
    cut_edges_.push_back({.first = edge.first, .second = edge.second, .weight = edge.weight});
  }
  cut_finder_.set_least_vertices(options.svc.min_voxels);
  return cutter_.cut(voxels, cut_edges_,
                     {.eigenvectors = options.partition.eigenvectors,
                      .utility_threshold = options.svc.utility_threshold,
                      .decomposition = options.partition.decomposition,
                      .laplacian = {.normalisation = options.partition.laplacian}},
                     cut_finder_, segment);
}

}  // namespace cleave::segmentation
