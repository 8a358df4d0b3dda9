// Which supervoxels of cells touch (section 4.1.2.1).
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/adjacency.hpp"
#include "segmentation/cell_image.hpp"
#include "segmentation/cell_links.hpp"

namespace cleave::segmentation {

class CellAdjacencyFinder {
 public:
  // Two supervoxels are adjacent if a cell of one is linked to a cell of the other. Sorted by
  // (first, second); `touching_voxels` counts links.
  void find(const CellImage& cells, const CellLinks& links,
            const std::vector<std::uint32_t>& supervoxel, std::vector<AdjacentPair>& pairs);

 private:
  std::vector<std::uint64_t> key_;
  CellRanking ranking_;
};

}  // namespace cleave::segmentation
