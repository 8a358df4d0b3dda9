// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_adjacency.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "segmentation/math/multiversion.hpp"

namespace cleave::segmentation {

// A supervoxel has few neighbours: their list is searched from the front.
void CellAdjacencyFinder::count_link(std::uint32_t first, std::uint32_t second) {
  for (std::uint32_t n = list_[first]; n != no_index; n = neighbours_[n].next) {
    if (neighbours_[n].second != second) continue;
    ++neighbours_[n].links;
    return;
  }
  neighbours_.push_back({.second = second, .links = 1, .next = list_[first]});
  list_[first] = static_cast<std::uint32_t>(neighbours_.size() - 1);
}

namespace {

// Bits of the steps on which a row's cells are linked to cells of other supervoxels.
CLEAVE_MULTIVERSION
void find_borders(const std::uint8_t* __restrict links, const std::uint32_t* __restrict supervoxel,
                  const std::array<std::ptrdiff_t, 4>& steps, std::ptrdiff_t count,
                  std::uint32_t* __restrict borders) {
  const auto [east, south_west, south, south_east] = steps;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::uint32_t own = supervoxel[i];
    const std::uint32_t differs =
        (supervoxel[i + east] != own ? 1U : 0U) | (supervoxel[i + south_west] != own ? 2U : 0U) |
        (supervoxel[i + south] != own ? 4U : 0U) | (supervoxel[i + south_east] != own ? 8U : 0U);
    borders[i] = differs & links[i];
  }
}

}  // namespace

void CellAdjacencyFinder::find(const CellImage& cells, const CellLinks& links,
                               const std::vector<std::uint32_t>& supervoxel,
                               std::size_t supervoxels, std::vector<AdjacentPair>& pairs) {
  const auto steps = cells.steps();
  list_.assign(supervoxels, no_index);
  neighbours_.clear();
  borders_.resize(cells.columns);
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    find_borders(&links[begin], &supervoxel[begin], steps, cells.columns, borders_.data());
    for (std::uint32_t column = 0; column < cells.columns; ++column) {
      const std::size_t i = begin + column;
      for (std::uint32_t left = borders_[column]; left != 0; left &= left - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t other = supervoxel[i + static_cast<std::size_t>(steps[k])];
        count_link(std::min(supervoxel[i], other), std::max(supervoxel[i], other));
      }
    }
  }

  pairs.clear();
  for (std::uint32_t first = 0; first < supervoxels; ++first) {
    const auto begin = static_cast<std::ptrdiff_t>(pairs.size());
    for (std::uint32_t n = list_[first]; n != no_index; n = neighbours_[n].next) {
      pairs.push_back({.first = first,
                       .second = neighbours_[n].second,
                       .touching_voxels = neighbours_[n].links});
    }
    std::sort(pairs.begin() + begin, pairs.end(),
              [](const AdjacentPair& l, const AdjacentPair& r) { return l.second < r.second; });
  }
}

}  // namespace cleave::segmentation
