#include "segmentation/voxel_neighbours.hpp"

#include <array>

namespace cleave::segmentation {
namespace {

// Neighbours lie in nine rows of three cells along x. For ascending voxels each of those rows
// moves forward through the sorted keys, and so does the place where it starts.
struct Row {
  std::uint64_t offset = 0;     // of the row's middle cell from the voxel, modulo 2^64
  std::uint32_t candidate = 0;  // first voxel that can still lie in the row
};

std::array<Row, 9> rows_around_a_voxel(const CellPacking& packing) {
  std::array<Row, 9> rows;
  auto row = rows.begin();
  for (const std::uint64_t dz : {-packing.stride_z, std::uint64_t{0}, packing.stride_z}) {
    for (const std::uint64_t dy : {-packing.stride_y, std::uint64_t{0}, packing.stride_y}) {
      (row++)->offset = dz + dy;
    }
  }
  return rows;
}

}  // namespace

void find_voxel_neighbours(const VoxelGrid& grid, NeighbourLists& neighbours) {
  auto rows = rows_around_a_voxel(grid.packing);
  const auto& key = grid.key;
  const auto count = static_cast<std::uint32_t>(grid.size());
  neighbours.begin.assign(1, 0);
  neighbours.neighbour.clear();

  for (std::uint32_t v = 0; v < count; ++v) {
    for (Row& row : rows) {
      const std::uint64_t first = key[v] + row.offset - 1;
      while (row.candidate < count && key[row.candidate] < first) ++row.candidate;
      for (std::uint32_t u = row.candidate; u < count && key[u] <= first + 2; ++u) {
        if (u != v) neighbours.neighbour.push_back(u);
      }
    }
    neighbours.begin.push_back(static_cast<std::uint32_t>(neighbours.neighbour.size()));
  }
}

}  // namespace cleave::segmentation
