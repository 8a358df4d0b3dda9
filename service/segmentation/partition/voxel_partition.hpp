// SPDX-License-Identifier: BSD-3-Clause
// Spectral Voxel Clustering (section 4.2.3): Algorithm 1 with the cuts of Algorithm 3.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/options.hpp"
#include "segmentation/partition/potential_cut.hpp"
#include "segmentation/partition/spectral_cuts.hpp"

namespace cleave::segmentation {

// Reuses its memory; deterministic.
class VoxelPartitioner {
 public:
  // Gives every voxel a segment, numbered from 0 without gaps, and returns their number.
  std::uint32_t partition(std::uint32_t voxels, const std::vector<SupervoxelEdge>& edges,
                          const Options& options, std::vector<std::uint32_t>& segment);

 private:
  SpectralCutter cutter_;
  PotentialCutFinder cut_finder_;
  std::vector<CutEdge> cut_edges_;
};

}  // namespace cleave::segmentation
