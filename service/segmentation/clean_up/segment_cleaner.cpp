// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/segment_cleaner.hpp"

namespace cleave::segmentation {

void SegmentCleaner::clean(const std::vector<SupervoxelEdge>& edges,
                           const std::vector<Surfel>& surfels,
                           const std::vector<std::uint32_t>& points, std::uint32_t segments,
                           const Options& options, std::vector<std::uint32_t>& segment) {
  CleanUpOptions clean_up = options.clean_up;
  if (options.algorithm == Algorithm::svc || options.algorithm == Algorithm::convex_components) {
    clean_up.join_across_borders = false;
    clean_up.weak_border_points = 0;
  }
  if (clean_up.join_across_borders) {
    joiner_.join(edges, surfels, options.graph, segments, segment);
  }
  merger_.merge(edges, points, segments, clean_up, segment);
}

}  // namespace cleave::segmentation
