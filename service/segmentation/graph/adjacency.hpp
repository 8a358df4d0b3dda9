// SPDX-License-Identifier: BSD-3-Clause
// Which supervoxels touch (section 4.1.2.1).
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/math/neighbour_lists.hpp"

namespace cleave::segmentation {

struct AdjacentPair {
  std::uint32_t first = 0, second = 0;  // first < second
  std::uint32_t touching_voxels = 0;    // pairs of neighbouring voxels across the border
};

class AdjacencyFinder {
 public:
  // Two supervoxels are adjacent if a voxel of one neighbours a voxel of the other. Sorted by
  // (first, second).
  void find(const std::vector<std::uint32_t>& supervoxel_of_voxel, const NeighbourLists& neighbours,
            std::vector<AdjacentPair>& pairs);

 private:
  std::vector<std::uint64_t> key_;
  CellRanking ranking_;
};

}  // namespace cleave::segmentation
