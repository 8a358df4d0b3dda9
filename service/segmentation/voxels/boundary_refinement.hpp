// SPDX-License-Identifier: BSD-3-Clause
// Borders finer than a voxel.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxels.hpp"
#include "segmentation/math/neighbour_lists.hpp"
#include "segmentation/points/point_set.hpp"
#include "segmentation/voxels/voxel_grid.hpp"

namespace cleave::segmentation {

// A voxel lies on a border if a neighbour belongs to another segment. Each point of such a voxel
// goes to the supervoxel, of its own voxel or of the neighbours, whose plane is nearest: at a
// crease the planes say exactly where the border runs.
class BoundaryRefiner {
 public:
  // Changes `segment_of_point` of points in border voxels.
  void refine(const PointSet& points, const VoxelGrid& grid, const NeighbourLists& neighbours,
              const Supervoxels& supervoxels,
              const std::vector<std::uint32_t>& segment_of_supervoxel,
              std::vector<std::uint32_t>& segment_of_point);

 private:
  void find_candidates(const NeighbourLists& neighbours, const Supervoxels& supervoxels,
                       const std::vector<std::uint32_t>& segment_of_supervoxel);

  NeighbourLists candidates_;  // supervoxels, a voxel; none inside a segment
};

}  // namespace cleave::segmentation
