// SPDX-License-Identifier: BSD-3-Clause
// From the graph to segments, by the algorithm that the options name.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/options.hpp"
#include "segmentation/partition/convex_components.hpp"
#include "segmentation/partition/partition.hpp"
#include "segmentation/partition/voxel_partition.hpp"

namespace cleave::segmentation {

// Reuses its memory; deterministic.
class GraphPartitioner {
 public:
  // Gives every supervoxel (of svc: every voxel) a segment, numbered from 0 without gaps, and
  // returns their number. Only valid edges connect and count.
  std::uint32_t partition(std::uint32_t supervoxels, const std::vector<SupervoxelEdge>& edges,
                          const Options& options, std::vector<std::uint32_t>& segment);

 private:
  Partitioner partitioner_;
  VoxelPartitioner voxel_partitioner_;
  ConvexComponents convex_components_;
};

}  // namespace cleave::segmentation
