// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/convex_components.hpp"

#include <algorithm>
#include <numeric>

#include "segmentation/math/portable_math.hpp"

namespace cleave::segmentation {

std::uint32_t ConvexComponents::root(std::uint32_t supervoxel) {
  while (parent_[supervoxel] != supervoxel) {
    parent_[supervoxel] = parent_[parent_[supervoxel]];
    supervoxel = parent_[supervoxel];
  }
  return supervoxel;
}

std::uint32_t ConvexComponents::find(std::uint32_t supervoxels,
                                     const std::vector<SupervoxelEdge>& edges,
                                     const ConvexComponentsOptions& options,
                                     std::vector<std::uint32_t>& segment) {
  const auto least_cosine = static_cast<float>(portable::cos(options.tolerance_rad));
  parent_.resize(supervoxels);
  std::iota(parent_.begin(), parent_.end(), 0U);
  for (const SupervoxelEdge& edge : edges) {
    if (!edge.valid || !(edge.convex || edge.cosine >= least_cosine)) continue;
    const std::uint32_t a = root(edge.first);
    const std::uint32_t b = root(edge.second);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  segment.resize(supervoxels);
  std::uint32_t segments = 0;
  for (std::uint32_t s = 0; s < supervoxels; ++s) {
    const std::uint32_t first = root(s);
    segment[s] = first == s ? segments++ : segment[first];
  }
  return segments;
}

}  // namespace cleave::segmentation
