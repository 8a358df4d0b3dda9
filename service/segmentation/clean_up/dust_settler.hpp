// SPDX-License-Identifier: BSD-3-Clause
// No segment that is published is dust: what the refinement of borders left too small joins a
// neighbour, and what touches nothing is no segment.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/clean_up/clean_up.hpp"
#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/options.hpp"
#include "segmentation/points/point_runs.hpp"

namespace cleave::segmentation {

// Counts the points that segments have in the end. Those with fewer than min_segment_points join a
// neighbour as SmallSegmentMerger has it; what has too few even so is an island of noise, and is
// dropped. With 0 nothing joins and nothing is dropped.
class DustSettler {
 public:
  // `settled`: of a segment, the one that its points belong to now, or no_index. `runs`: of the
  // final segments; `edges`, of supervoxels, tell which segments touch.
  void settle(std::span<const PointRun> runs, const std::vector<SupervoxelEdge>& edges,
              const std::vector<std::uint32_t>& segment_of_supervoxel, std::uint32_t segments,
              std::uint32_t min_segment_points, std::vector<std::uint32_t>& settled);

 private:
  void list_contacts(const std::vector<SupervoxelEdge>& edges,
                     const std::vector<std::uint32_t>& segment_of_supervoxel);
  void drop_islands(std::uint32_t min_segment_points, std::vector<std::uint32_t>& settled);

  SmallSegmentMerger merger_;
  std::vector<std::uint32_t> points_;     // of a segment
  std::vector<std::uint32_t> points_in_;  // of a segment, with those that joined it
  std::vector<SupervoxelEdge> contacts_;  // of segments
};

}  // namespace cleave::segmentation
