// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/partition.hpp"

namespace cleave::segmentation {

std::uint32_t Partitioner::cut(std::uint32_t supervoxels, const std::vector<SupervoxelEdge>& edges,
                               std::uint32_t coarsening_rounds, const SpectralSettings& settings,
                               std::vector<std::uint32_t>& segment) {
  const std::uint32_t vertices = coarsener_.coarsen(supervoxels, edges, coarsening_rounds);
  const std::uint32_t segments =
      cutter_.cut(vertices, coarsener_.edges(), settings, best_cut_finder_, segment_of_vertex_);
  segment.resize(supervoxels);
  for (std::uint32_t s = 0; s < supervoxels; ++s) {
    segment[s] = segment_of_vertex_[coarsener_.vertex_of_supervoxel()[s]];
  }
  return segments;
}

std::uint32_t Partitioner::partition(std::uint32_t supervoxels,
                                     const std::vector<SupervoxelEdge>& edges,
                                     const PartitionOptions& options,
                                     std::vector<std::uint32_t>& segment) {
  return cut(supervoxels, edges, options.coarsening_rounds,
             {.eigenvectors = options.eigenvectors,
              .utility_threshold = options.utility_threshold,
              .decomposition = options.decomposition,
              .laplacian = {.normalisation = options.laplacian}},
             segment);
}

std::uint32_t Partitioner::partition_constrained(std::uint32_t supervoxels,
                                                 const std::vector<SupervoxelEdge>& edges,
                                                 const PartitionOptions& options,
                                                 std::vector<std::uint32_t>& segment) {
  // At 0 the signed ratio cut is the ratio cut (section 5.3.3).
  const bool is_signed = options.cannot_link_weight > 0;
  return cut(supervoxels, edges, options.coarsening_rounds,
             {.eigenvectors = 1,
              .utility_threshold = options.utility_threshold,
              .decomposition = options.decomposition,
              .laplacian = {.normalisation = options.laplacian, .is_signed = is_signed},
              .constrained = is_signed,
              .cannot_link_weight = options.cannot_link_weight},
             segment);
}

}  // namespace cleave::segmentation
