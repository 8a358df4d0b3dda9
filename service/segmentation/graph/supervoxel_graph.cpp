// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/supervoxel_graph.hpp"

#include <algorithm>

#include "segmentation/graph/edge_heuristics.hpp"
#include "segmentation/math/portable_math.hpp"

namespace cleave::segmentation {

void build_supervoxel_graph(const std::vector<AdjacentPair>& pairs,
                            const std::vector<Surfel>& supervoxels, const GraphOptions& options,
                            std::vector<SupervoxelEdge>& edges) {
  const float least_weight = cannot_link_weight(options);
  const auto straight = static_cast<float>(portable::cos(options.soft_cannot_link_rad));
  edges.clear();
  for (const AdjacentPair& pair : pairs) {
    const Surfel& i = supervoxels[pair.first];
    const Surfel& j = supervoxels[pair.second];
    SupervoxelEdge edge = {.first = pair.first,
                           .second = pair.second,
                           .touching_voxels = pair.touching_voxels,
                           .weight = edge_weight(i, j, options),
                           .cosine = i.normal.dot(j.normal),
                           .convex = is_convex(i, j, options.convexity),
                           .valid = is_valid(i, j, options) && !is_step(i, j, options)};
    if (edge.weight < least_weight) {
      edge.cannot_link_share = 1;
    } else if (!edge.convex && edge.cosine < straight) {
      const auto beta_rad =
          static_cast<float>(portable::acos(std::clamp(edge.cosine, -1.0F, 1.0F)));
      edge.cannot_link_share = cannot_link_share(beta_rad, options);
    }
    edges.push_back(edge);
  }
}

}  // namespace cleave::segmentation
