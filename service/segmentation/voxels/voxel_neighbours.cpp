// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/voxel_neighbours.hpp"

#include <array>
#include <span>

namespace cleave::segmentation {
namespace {

// Neighbours lie in nine rows of three cells along x. For ascending voxels each of those rows
// moves forward through the sorted keys, and so does the place where it starts.
struct Row {
  std::uint64_t offset = 0;     // of the row's first cell from the voxel, modulo 2^64
  std::uint64_t length = 0;     // cells beyond the first
  std::uint32_t candidate = 0;  // first voxel that can still lie in the row
};

// In how many axes a neighbour may differ at most.
int most_axes(Neighbourhood neighbourhood) {
  if (neighbourhood == Neighbourhood::faces) return 1;
  return neighbourhood == Neighbourhood::edges ? 2 : 3;
}

struct Rows {
  std::array<Row, 9> row;
  std::size_t count = 0;
};

Rows rows_around_a_voxel(const CellPacking& packing, Neighbourhood neighbourhood) {
  Rows rows;
  for (const int dz : {-1, 0, 1}) {
    for (const int dy : {-1, 0, 1}) {
      const int axes_left = most_axes(neighbourhood) - dz * dz - dy * dy;
      if (axes_left < 0) continue;
      const std::uint64_t reach = axes_left > 0 ? 1 : 0;
      const std::uint64_t middle = static_cast<std::uint64_t>(dz) * packing.stride_z +
                                   static_cast<std::uint64_t>(dy) * packing.stride_y;
      rows.row[rows.count++] = {.offset = middle - reach, .length = 2 * reach, .candidate = 0};
    }
  }
  return rows;
}

}  // namespace

void find_voxel_neighbours(const VoxelGrid& grid, Neighbourhood neighbourhood,
                           NeighbourLists& neighbours) {
  auto rows = rows_around_a_voxel(grid.packing, neighbourhood);
  const auto& key = grid.key;
  const auto count = static_cast<std::uint32_t>(grid.size());
  neighbours.begin.assign(1, 0);
  neighbours.neighbour.clear();

  for (std::uint32_t v = 0; v < count; ++v) {
    for (Row& row : std::span(rows.row).first(rows.count)) {
      const std::uint64_t first = key[v] + row.offset;
      while (row.candidate < count && key[row.candidate] < first) ++row.candidate;
      for (std::uint32_t u = row.candidate; u < count && key[u] <= first + row.length; ++u) {
        if (u != v) neighbours.neighbour.push_back(u);
      }
    }
    neighbours.begin.push_back(static_cast<std::uint32_t>(neighbours.neighbour.size()));
  }
}

}  // namespace cleave::segmentation
