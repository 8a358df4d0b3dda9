// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/supervoxel_fragments.hpp"

#include <limits>

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {
namespace {
constexpr std::uint32_t min_own_voxels = 3;  // voxels
}  // namespace

void FragmentMender::find_pieces(const NeighbourLists& neighbours,
                                 const std::vector<std::uint32_t>& owner) {
  pieces_.clear();
  member_.clear();
  piece_of_voxel_.assign(owner.size(), no_index);
  for (std::uint32_t v = 0; v < owner.size(); ++v) {
    if (piece_of_voxel_[v] != no_index) continue;
    const auto piece = static_cast<std::uint32_t>(pieces_.size());
    const auto begin = static_cast<std::uint32_t>(member_.size());
    piece_of_voxel_[v] = piece;
    member_.push_back(v);
    for (std::size_t next = begin; next < member_.size(); ++next) {
      for (const std::uint32_t u : neighbours[member_[next]]) {
        if (piece_of_voxel_[u] != no_index || owner[u] != owner[v]) continue;
        piece_of_voxel_[u] = piece;
        member_.push_back(u);
      }
    }
    pieces_.push_back({.owner = owner[v],
                       .begin = begin,
                       .end = static_cast<std::uint32_t>(member_.size()),
                       .stays = false,
                       .joins = piece});
  }
}

void FragmentMender::decide_who_stays(std::size_t owners) {
  const auto size = [](const Piece& piece) { return piece.end - piece.begin; };
  largest_piece_.assign(owners, no_index);
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    std::uint32_t& largest = largest_piece_[pieces_[p].owner];
    if (largest == no_index || size(pieces_[p]) > size(pieces_[largest])) largest = p;
  }
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    pieces_[p].stays = largest_piece_[pieces_[p].owner] == p || size(pieces_[p]) >= min_own_voxels;
  }
}

void FragmentMender::find_new_home(std::uint32_t piece, const std::vector<Surfel>& voxels,
                                   const NeighbourLists& neighbours,
                                   const std::vector<Surfel>& centre,
                                   const SupervoxelMetric& distance) {
  float nearest = std::numeric_limits<float>::infinity();
  for (std::uint32_t m = pieces_[piece].begin; m < pieces_[piece].end; ++m) {
    const std::uint32_t v = member_[m];
    for (const std::uint32_t u : neighbours[v]) {
      const std::uint32_t candidate = piece_of_voxel_[u];
      if (!pieces_[candidate].stays) continue;
      const float d = distance(voxels[v], centre[pieces_[candidate].owner]);
      if (d < nearest) {
        nearest = d;
        pieces_[piece].joins = candidate;
      }
    }
  }
}

std::uint32_t FragmentMender::mend(const std::vector<Surfel>& voxels,
                                   const NeighbourLists& neighbours,
                                   const std::vector<Surfel>& centre,
                                   const SupervoxelMetric& distance,
                                   const std::vector<std::uint32_t>& owner,
                                   std::vector<std::uint32_t>& supervoxel_of_voxel) {
  find_pieces(neighbours, owner);
  decide_who_stays(centre.size());
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    if (!pieces_[p].stays) find_new_home(p, voxels, neighbours, centre, distance);
  }

  std::uint32_t count = 0;
  number_.assign(pieces_.size(), no_index);
  supervoxel_of_voxel.resize(owner.size());
  for (std::size_t v = 0; v < owner.size(); ++v) {
    std::uint32_t& number = number_[pieces_[piece_of_voxel_[v]].joins];
    if (number == no_index) number = count++;
    supervoxel_of_voxel[v] = number;
  }
  return count;
}

}  // namespace cleave::segmentation
