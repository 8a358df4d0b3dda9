// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/adjacency.hpp"

#include <bit>

namespace cleave::segmentation {

void AdjacencyFinder::find(const std::vector<std::uint32_t>& supervoxel_of_voxel,
                           const NeighbourLists& neighbours, std::vector<AdjacentPair>& pairs) {
  const auto count = static_cast<std::uint32_t>(supervoxel_of_voxel.size());
  // Supervoxels are at most as many as voxels. The fewer bits a key has, the faster it is ranked.
  const int bits = std::bit_width(count);
  key_.clear();
  for (std::uint32_t v = 0; v < count; ++v) {
    const std::uint64_t first = supervoxel_of_voxel[v];
    for (const std::uint32_t u : neighbours[v]) {
      const std::uint64_t second = supervoxel_of_voxel[u];
      if (first < second) key_.push_back((first << bits) | second);
    }
  }
  ranking_.rank(key_);

  pairs.clear();
  for (const std::uint64_t key : ranking_.distinct_keys()) {
    pairs.push_back({.first = static_cast<std::uint32_t>(key >> bits),
                     .second = static_cast<std::uint32_t>(key & ((std::uint64_t{1} << bits) - 1)),
                     .touching_voxels = 0});
  }
  for (const std::uint32_t pair : ranking_.rank_of_item()) ++pairs[pair].touching_voxels;
}

}  // namespace cleave::segmentation
