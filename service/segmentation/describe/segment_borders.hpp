// SPDX-License-Identifier: BSD-3-Clause
// Which segments touch, and how.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::segmentation {

class BorderDescriber {
 public:
  // Segments touch if supervoxels of theirs are adjacent. The border is convex if equation 4.1
  // holds along more than half of its length; edges that equation 4.6 calls invalid, for they are
  // no borders of surfaces, count only where there is no other. Sorted by (first, second).
  void describe(const std::vector<SupervoxelEdge>& edges,
                const std::vector<std::uint32_t>& segment_of_supervoxel,
                const std::vector<std::uint16_t>& label_of_segment, std::vector<Border>& borders);

 private:
  struct Length {
    std::uint64_t convex = 0, concave = 0;                  // touching voxels of valid edges
    std::uint64_t invalid_convex = 0, invalid_concave = 0;  // of the others
    [[nodiscard]] bool is_convex() const {
      return convex + concave > 0 ? convex > concave : invalid_convex > invalid_concave;
    }
  };
  std::vector<const SupervoxelEdge*> between_segments_;
  std::vector<std::uint64_t> labels_;
  CellRanking ranking_;
  std::vector<Length> lengths_;
};

}  // namespace cleave::segmentation
