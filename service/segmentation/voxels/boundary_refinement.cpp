// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/boundary_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleave::segmentation {
namespace {

std::uint32_t nearest_plane(const Eigen::Vector3f& point, const std::vector<Surfel>& supervoxels,
                            std::span<const std::uint32_t> candidates) {
  std::uint32_t nearest = candidates.front();
  float least_distance_m = std::numeric_limits<float>::infinity();
  for (const std::uint32_t s : candidates) {
    const Surfel& plane = supervoxels[s];
    const float distance_m = std::abs(plane.normal.dot(point - plane.position));
    if (distance_m < least_distance_m) {
      least_distance_m = distance_m;
      nearest = s;
    }
  }
  return nearest;
}

}  // namespace

void BoundaryRefiner::find_candidates(const NeighbourLists& neighbours,
                                      const Supervoxels& supervoxels,
                                      const std::vector<std::uint32_t>& segment_of_supervoxel) {
  auto& found = candidates_.neighbour;
  candidates_.begin.assign(1, 0);
  found.clear();
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    const std::uint32_t own = supervoxels.of_voxel[v];
    const std::size_t begin = found.size();
    bool on_border = false;
    found.push_back(own);
    for (const std::uint32_t u : neighbours[v]) {
      const std::uint32_t other = supervoxels.of_voxel[u];
      if (other == found.back()) continue;
      on_border = on_border || segment_of_supervoxel[other] != segment_of_supervoxel[own];
      if (std::find(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(), other) ==
          found.end()) {
        found.push_back(other);
      }
    }
    if (!on_border) found.resize(begin);
    candidates_.begin.push_back(static_cast<std::uint32_t>(found.size()));
  }
}

void BoundaryRefiner::refine(const PointSet& points, const VoxelGrid& grid,
                             const NeighbourLists& neighbours, const Supervoxels& supervoxels,
                             const std::vector<std::uint32_t>& segment_of_supervoxel,
                             std::vector<std::uint32_t>& segment_of_point) {
  find_candidates(neighbours, supervoxels, segment_of_supervoxel);
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    const auto candidates = candidates_[grid.run_voxel[run]];
    if (candidates.empty()) continue;
    for (std::uint32_t i = grid.run_begin[run]; i < grid.run_begin[run + 1]; ++i) {
      const Eigen::Vector3f point(points.x[i], points.y[i], points.z[i]);
      segment_of_point[i] =
          segment_of_supervoxel[nearest_plane(point, supervoxels.surfel, candidates)];
    }
  }
}

}  // namespace cleave::segmentation
