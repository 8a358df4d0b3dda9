// SPDX-License-Identifier: BSD-3-Clause
// Spectral Supervoxel Clustering (section 4.1.3), plain and constrained (4.1.4).
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/coarse_graph.hpp"
#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/options.hpp"
#include "segmentation/partition/best_cut.hpp"
#include "segmentation/partition/spectral_cuts.hpp"

namespace cleave::segmentation {

class Partitioner {
 public:
  // Gives every supervoxel a segment, numbered from 0 without gaps, and returns their number. Only
  // valid edges connect and count. Supervoxels that coarsening has joined stay together.
  std::uint32_t partition(std::uint32_t supervoxels, const std::vector<SupervoxelEdge>& edges,
                          const PartitionOptions& options, std::vector<std::uint32_t>& segment);

  // The same on the signed Laplacian (equation 4.14), along its one smallest eigenvector: that no
  // more than one is sound is proven for cuts in two only.
  std::uint32_t partition_constrained(std::uint32_t supervoxels,
                                      const std::vector<SupervoxelEdge>& edges,
                                      const PartitionOptions& options,
                                      std::vector<std::uint32_t>& segment);

 private:
  std::uint32_t cut(std::uint32_t supervoxels, const std::vector<SupervoxelEdge>& edges,
                    std::uint32_t coarsening_rounds, const SpectralSettings& settings,
                    std::vector<std::uint32_t>& segment);

  GraphCoarsener coarsener_;
  SpectralCutter cutter_;
  BestCutFinder best_cut_finder_;
  std::vector<std::uint32_t> segment_of_vertex_;
};

}  // namespace cleave::segmentation
