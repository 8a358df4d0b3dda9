// SPDX-License-Identifier: BSD-3-Clause
// Which supervoxels of cells touch (section 4.1.2.1).
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/cells/cell_image.hpp"
#include "segmentation/cells/cell_links.hpp"
#include "segmentation/graph/adjacency.hpp"
#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {

class CellAdjacencyFinder {
 public:
  // Two supervoxels are adjacent if a cell of one is linked to a cell of the other. Sorted by
  // (first, second); `touching_voxels` counts links.
  void find(const CellImage& cells, const CellLinks& links,
            const std::vector<std::uint32_t>& supervoxel, std::size_t supervoxels,
            std::vector<AdjacentPair>& pairs);

 private:
  struct Neighbour {
    std::uint32_t second = 0, links = 0;
    std::uint32_t next = no_index;  // in the list of the same first supervoxel
  };
  void count_link(std::uint32_t first, std::uint32_t second);

  std::vector<std::uint32_t> list_;  // of a supervoxel, the latest neighbour; no_index: empty
  std::vector<Neighbour> neighbours_;
  std::vector<std::uint32_t> borders_;  // of a row
};

}  // namespace cleave::segmentation
