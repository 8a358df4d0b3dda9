// SPDX-License-Identifier: BSD-3-Clause
// The second half of the method alone, on supervoxels that someone else has made: what shows
// whether theirs or ours are better, and what a caller with supervoxels of its own needs.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/clean_up/segment_cleaner.hpp"
#include "segmentation/graph/adjacency.hpp"
#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/graph/surfel.hpp"
#include "segmentation/options.hpp"
#include "segmentation/partition/graph_partition.hpp"

namespace cleave::segmentation {

// Centroid and normal of each supervoxel (finite; normals of unit length, towards the sensor), the
// number of its points, and which of them touch, sorted by (first, second).
struct ForeignSupervoxels {
  std::vector<Surfel> surfel;
  std::vector<std::uint32_t> point_count;
  std::vector<AdjacentPair> adjacent_pairs;
};

// Graph, partition and clean-up. Reuses its memory; deterministic.
class SupervoxelPartitioner {
 public:
  // Gives every supervoxel a segment below the number returned; a number whose segment joined
  // another in the clean-up is not used.
  std::uint32_t partition(const ForeignSupervoxels& supervoxels, const Options& options,
                          std::vector<std::uint32_t>& segment);

 private:
  GraphPartitioner partitioner_;
  SegmentCleaner cleaner_;
  std::vector<SupervoxelEdge> edges_;
};

}  // namespace cleave::segmentation
