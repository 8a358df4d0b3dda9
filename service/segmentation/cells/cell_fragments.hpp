// SPDX-License-Identifier: BSD-3-Clause
// Clusters fall apart where cells of one owner are not linked; this makes supervoxels of the parts.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/cells/cell_image.hpp"
#include "segmentation/cells/cell_links.hpp"
#include "segmentation/graph/supervoxel_metric.hpp"
#include "segmentation/math/union_find.hpp"

namespace cleave::segmentation {

// A piece is what links connect among cells of one owner, or of none. The largest piece of an owner
// and every piece of at least three cells is a supervoxel; smaller ones join, cell by cell, the
// linked neighbour that is nearest and most alike, or are supervoxels if nothing is linked to them.
class CellFragmentMender {
 public:
  // Supervoxel of every occupied cell, no_owner of CellClusterer for empty ones; numbered from 0
  // without gaps in the order of their first cells. Returns the count.
  std::uint32_t mend(const CellImage& cells, const CellLinks& links,
                     const std::vector<std::uint32_t>& owner, std::uint32_t owners,
                     const SupervoxelOptions& options, std::vector<std::uint32_t>& supervoxel);

 private:
  struct Piece {
    std::uint32_t owner = 0;
    std::uint32_t cells = 0;
    bool stays = false;
  };
  void find_pieces(const CellImage& cells, const CellLinks& links,
                   const std::vector<std::uint32_t>& owner);
  void decide_who_stays(std::uint32_t owners);
  void settle_loose_cells(const CellImage& cells, const CellLinks& links,
                          const SupervoxelOptions& options, std::vector<std::uint32_t>& supervoxel);

  std::vector<Piece> pieces_;
  UnionFind joined_;  // pieces; only roots are pieces any more
  std::vector<std::uint32_t> piece_of_cell_;
  std::vector<std::uint32_t> largest_piece_;        // of an owner
  std::vector<std::uint32_t> loose_, still_loose_;  // cells
  struct Move {
    std::uint32_t cell, piece;
  };
  std::vector<Move> moves_;
  std::vector<std::uint32_t> number_;  // of a piece in the result
};

}  // namespace cleave::segmentation
