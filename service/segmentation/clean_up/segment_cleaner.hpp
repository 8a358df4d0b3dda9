// SPDX-License-Identifier: BSD-3-Clause
// What follows a partition, whoever made the supervoxels.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/clean_up/border_joining.hpp"
#include "segmentation/clean_up/clean_up.hpp"
#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/graph/surfel.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Segments join across borders that give no reason to part them, then small ones join a neighbour.
// Spectral Voxel Clustering and convex components are other methods: they get what the thesis gives
// them, and slivers are merged. Reuses its memory; deterministic.
class SegmentCleaner {
 public:
  // Of each supervoxel: its surfel, its points, and its segment, below `segments`, in and out.
  void clean(const std::vector<SupervoxelEdge>& edges, const std::vector<Surfel>& surfels,
             const std::vector<std::uint32_t>& points, std::uint32_t segments,
             const Options& options, std::vector<std::uint32_t>& segment);

 private:
  BorderJoiner joiner_;
  SmallSegmentMerger merger_;
};

}  // namespace cleave::segmentation
