#include "segmentation/cell_adjacency.hpp"

#include <algorithm>

namespace cleave::segmentation {

void CellAdjacencyFinder::find(const CellImage& cells, const CellLinks& links,
                               const std::vector<std::uint32_t>& supervoxel,
                               std::vector<AdjacentPair>& pairs) {
  constexpr int bits = 32;
  const auto steps = cells.steps();
  key_.clear();
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    for (std::size_t i = begin; i < begin + cells.columns; ++i) {
      for (std::size_t k = 0; k < steps.size(); ++k) {
        if ((links[i] >> k & 1) == 0) continue;
        const std::uint32_t other = supervoxel[i + static_cast<std::size_t>(steps[k])];
        if (other == supervoxel[i]) continue;
        const auto [low, high] = std::minmax(supervoxel[i], other);
        key_.push_back((std::uint64_t{low} << bits) | high);
      }
    }
  }
  ranking_.rank(key_);

  pairs.clear();
  for (const std::uint64_t key : ranking_.distinct_keys()) {
    pairs.push_back({.first = static_cast<std::uint32_t>(key >> bits),
                     .second = static_cast<std::uint32_t>(key),
                     .touching_voxels = 0});
  }
  for (const std::uint32_t pair : ranking_.rank_of_item()) ++pairs[pair].touching_voxels;
}

}  // namespace cleave::segmentation
