// SPDX-License-Identifier: BSD-3-Clause
// Slivers that no one would call a segment join a neighbour.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Smallest first, every segment with fewer than min_segment_points joins the neighbour to which it
// has the largest summed weight of valid edges; one without a valid edge, the neighbour with the
// longest border; one without a neighbour stays. Ties go to the lower number. Larger ones join that
// neighbour if the border is weak, which it is if more than half of it is neither invalid nor
// cannot-link, and
// - the segment has fewer than weak_border_points, or
// - both have fewer than four times as many.
class SmallSegmentMerger {
 public:
  // `segment`, of a supervoxel, is changed in place; numbers of segments that joined are not used
  // any more.
  void merge(const std::vector<SupervoxelEdge>& edges,
             const std::vector<std::uint32_t>& points_of_supervoxel, std::uint32_t segments,
             const CleanUpOptions& options, std::vector<std::uint32_t>& segment);

 private:
  struct Bond {
    double weight = 0;
    std::uint32_t touching_voxels = 0;
    std::uint32_t linking_voxels = 0;  // of edges that are valid and not cannot-link
  };
  struct Neighbour {
    std::uint32_t segment;
    bool weakly_parted;
  };
  using SizeAndSegment = std::pair<std::uint32_t, std::uint32_t>;

  void list_edges_of_supervoxels(const std::vector<SupervoxelEdge>& edges, std::size_t supervoxels);
  void list_members(const std::vector<std::uint32_t>& segment, std::uint32_t segments);
  [[nodiscard]] Neighbour closest_neighbour(const std::vector<SupervoxelEdge>& edges,
                                            const std::vector<std::uint32_t>& segment,
                                            std::uint32_t small);
  [[nodiscard]] bool should_join(std::uint32_t small, const Neighbour& neighbour,
                                 const CleanUpOptions& options) const;
  void join(std::uint32_t small, std::uint32_t into, std::vector<std::uint32_t>& segment);

  std::vector<std::uint32_t> edge_begin_, edge_of_;  // rows of supervoxels
  std::vector<std::uint32_t> first_, last_, next_;   // linked lists of a segment's supervoxels
  std::vector<std::uint32_t> points_;                // of a segment
  std::vector<SizeAndSegment> heap_;
  std::vector<Bond> bond_;  // of a segment, with the one that is judged
  std::vector<std::uint32_t> bonded_;
};

}  // namespace cleave::segmentation
