// SPDX-License-Identifier: BSD-3-Clause
// The adjacency that the grid induces (section 2.1.2.1): voxels that share a face, edge or corner.
#pragma once

#include "segmentation/math/neighbour_lists.hpp"
#include "segmentation/options.hpp"
#include "segmentation/voxels/voxel_grid.hpp"

namespace cleave::segmentation {

// Up to 6, 18 or 26 neighbours a voxel, ascending; `automatic` is 26. One sweep over the sorted
// keys, without a lookup table.
void find_voxel_neighbours(const VoxelGrid& grid, Neighbourhood neighbourhood,
                           NeighbourLists& neighbours);

}  // namespace cleave::segmentation
