// SPDX-License-Identifier: BSD-3-Clause
// What the spectral methods are compared with: segments without any partitioning of the graph.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/math/union_find.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Connected components over the valid edges (equation 4.6) that are convex (4.1) or bend by no more
// than a tolerance: region growing, in which one weak edge is enough to join two objects. The
// tolerance is its own, as it must be tighter than the angle of equation 4.7: no other edges stand
// against one that is wrong. Deterministic; no allocation once warm.
class ConvexComponents {
 public:
  // Gives every supervoxel a segment, numbered from 0 without gaps in the order of their first
  // supervoxels, and returns their number.
  std::uint32_t find(std::uint32_t supervoxels, const std::vector<SupervoxelEdge>& edges,
                     const ConvexComponentsOptions& options, std::vector<std::uint32_t>& segment);

 private:
  UnionFind connected_;  // supervoxels
};

}  // namespace cleave::segmentation
