// SPDX-License-Identifier: BSD-3-Clause
// The graph of Spectral Voxel Clustering: voxels and their neighbours (section 4.2.2).
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/graph/surfel.hpp"
#include "segmentation/math/neighbour_lists.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Equation 4.15, of every voxel: do the normals of most of its neighbours lean away from it? One
// without neighbours is not convex.
void find_convex_voxels(const std::vector<Surfel>& voxels, const NeighbourLists& neighbours,
                        std::vector<std::uint8_t>& is_convex);

// Equation 4.16 for a concave edge, both functions inverse quadratic; c_i, c_j: curvatures.
[[nodiscard]] float concave_voxel_weight(const Surfel& i, const Surfel& j, float c_i, float c_j,
                                         const SvcOptions& options);

// Reuses its memory; deterministic.
class VoxelGraphBuilder {
 public:
  // An edge a pair of neighbours, convex if both voxels are, sorted by (first, second). All are
  // valid and none is cannot-link: neither means anything between voxels.
  void build(const std::vector<Surfel>& voxels, const std::vector<float>& curvature,
             const NeighbourLists& neighbours, const SvcOptions& options,
             std::vector<SupervoxelEdge>& edges);

 private:
  std::vector<std::uint8_t> is_convex_;  // a voxel
};

}  // namespace cleave::segmentation
