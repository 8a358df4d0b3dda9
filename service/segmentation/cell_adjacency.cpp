#include "segmentation/cell_adjacency.hpp"

#include <algorithm>

namespace cleave::segmentation {

// A supervoxel has few neighbours: their list is searched from the front.
void CellAdjacencyFinder::count_link(std::uint32_t first, std::uint32_t second) {
  for (std::uint32_t n = list_[first]; n != none; n = neighbours_[n].next) {
    if (neighbours_[n].second != second) continue;
    ++neighbours_[n].links;
    return;
  }
  neighbours_.push_back({.second = second, .links = 1, .next = list_[first]});
  list_[first] = static_cast<std::uint32_t>(neighbours_.size() - 1);
}

void CellAdjacencyFinder::find(const CellImage& cells, const CellLinks& links,
                               const std::vector<std::uint32_t>& supervoxel,
                               std::size_t supervoxels, std::vector<AdjacentPair>& pairs) {
  const auto steps = cells.steps();
  list_.assign(supervoxels, none);
  neighbours_.clear();
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    for (std::size_t i = begin; i < begin + cells.columns; ++i) {
      if (links[i] == 0) continue;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        if ((links[i] >> k & 1) == 0) continue;
        const std::uint32_t other = supervoxel[i + static_cast<std::size_t>(steps[k])];
        if (other == supervoxel[i]) continue;
        count_link(std::min(supervoxel[i], other), std::max(supervoxel[i], other));
      }
    }
  }

  pairs.clear();
  for (std::uint32_t first = 0; first < supervoxels; ++first) {
    const auto begin = static_cast<std::ptrdiff_t>(pairs.size());
    for (std::uint32_t n = list_[first]; n != none; n = neighbours_[n].next) {
      pairs.push_back({.first = first,
                       .second = neighbours_[n].second,
                       .touching_voxels = neighbours_[n].links});
    }
    std::sort(pairs.begin() + begin, pairs.end(),
              [](const AdjacentPair& l, const AdjacentPair& r) { return l.second < r.second; });
  }
}

}  // namespace cleave::segmentation
