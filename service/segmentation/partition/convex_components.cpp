// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/convex_components.hpp"

#include "segmentation/math/portable_math.hpp"

namespace cleave::segmentation {

std::uint32_t ConvexComponents::find(std::uint32_t supervoxels,
                                     const std::vector<SupervoxelEdge>& edges,
                                     const ConvexComponentsOptions& options,
                                     std::vector<std::uint32_t>& segment) {
  const auto least_cosine = static_cast<float>(portable::cos(options.tolerance_rad));
  connected_.reset(supervoxels);
  for (const SupervoxelEdge& edge : edges) {
    if (!edge.valid || !(edge.convex || edge.cosine >= least_cosine)) continue;
    connected_.join(edge.first, edge.second);
  }
  segment.resize(supervoxels);
  std::uint32_t segments = 0;
  for (std::uint32_t s = 0; s < supervoxels; ++s) {
    const std::uint32_t first = connected_.root(s);
    segment[s] = first == s ? segments++ : segment[first];
  }
  return segments;
}

}  // namespace cleave::segmentation
