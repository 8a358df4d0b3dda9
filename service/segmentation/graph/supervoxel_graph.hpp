// SPDX-License-Identifier: BSD-3-Clause
// The graph that is partitioned (section 4.1.2).
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/adjacency.hpp"
#include "segmentation/graph/surfel.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

struct SupervoxelEdge {
  std::uint32_t first = 0, second = 0;  // supervoxels, first < second
  std::uint32_t touching_voxels = 0;    // length of the border
  float weight = 0;                     // equation 4.3
  float cosine = 1;                     // of the angle between the normals
  bool convex = false;                  // equation 4.1 or 4.2
  bool valid = false;                   // equation 4.6; others do not count in the partition
  float cannot_link_share = 0;          // 1: cannot-link (equation 4.7); less: a soft constraint

  [[nodiscard]] bool is_cannot_link() const { return cannot_link_share >= 1; }
};

// One edge an adjacent pair, in the pairs' order.
void build_supervoxel_graph(const std::vector<AdjacentPair>& pairs,
                            const std::vector<Surfel>& supervoxels, const GraphOptions& options,
                            std::vector<SupervoxelEdge>& edges);

}  // namespace cleave::segmentation
