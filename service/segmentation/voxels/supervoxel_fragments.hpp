// SPDX-License-Identifier: BSD-3-Clause
// Growth can tear a supervoxel apart; this makes every supervoxel connected.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxel_metric.hpp"
#include "segmentation/graph/surfel.hpp"
#include "segmentation/math/neighbour_lists.hpp"

namespace cleave::segmentation {

// Of every owner's connected pieces the largest stays; others become supervoxels of their own or,
// when they are tiny, join the most similar neighbour.
class FragmentMender {
 public:
  // Numbers the result from 0 without gaps in the order of first voxels, and returns the count.
  std::uint32_t mend(const std::vector<Surfel>& voxels, const NeighbourLists& neighbours,
                     const std::vector<Surfel>& centre, const SupervoxelMetric& distance,
                     const std::vector<std::uint32_t>& owner,
                     std::vector<std::uint32_t>& supervoxel_of_voxel);

 private:
  struct Piece {
    std::uint32_t owner = 0;
    std::uint32_t begin = 0, end = 0;  // into member_
    bool stays = false;
    std::uint32_t joins = 0;  // piece; itself if it stays
  };

  void find_pieces(const NeighbourLists& neighbours, const std::vector<std::uint32_t>& owner);
  void decide_who_stays(std::size_t owners);
  void find_new_home(std::uint32_t piece, const std::vector<Surfel>& voxels,
                     const NeighbourLists& neighbours, const std::vector<Surfel>& centre,
                     const SupervoxelMetric& distance);

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> piece_of_voxel_;
  std::vector<std::uint32_t> member_;         // voxels by piece
  std::vector<std::uint32_t> largest_piece_;  // of an owner
  std::vector<std::uint32_t> number_;         // of a piece in the result
};

}  // namespace cleave::segmentation
