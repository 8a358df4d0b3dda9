// SPDX-License-Identifier: BSD-3-Clause
// Over-segmentation of cells into supervoxels (section 4.1.1).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "segmentation/cells/cell_image.hpp"
#include "segmentation/cells/cell_seeds.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// k-means in a window around every seed: Simple Linear Iterative Clustering (Achanta et al., "SLIC
// Superpixels Compared to State-of-the-art Superpixel Methods", PAMI 2012) with the distance of
// SupervoxelMetric. Clusters need not be connected yet: see CellFragmentMender.
class CellClusterer {
 public:
  static constexpr std::uint32_t no_owner = std::numeric_limits<std::uint32_t>::max();

  // Owner of every cell: the cluster that is nearest, the lowest among equals; no_owner for empty
  // cells and those in no cluster's window. Returns the number of clusters; some may own nothing.
  std::uint32_t cluster(const CellImage& cells, const SupervoxelOptions& options,
                        std::vector<std::uint32_t>& owner);

 private:
  struct Centre {
    float x = 0, y = 0, z = 0;
    float normal_x = 0, normal_y = 0, normal_z = 0;
    float column = 0, row = 0;
    float cells = 0;
  };
  void plant_seeds(const CellImage& cells);
  void assign_cells(const CellImage& cells, const SupervoxelOptions& options,
                    std::vector<std::uint32_t>& owner);
  void move_centres(const CellImage& cells, const std::vector<std::uint32_t>& owner);

  CellSeedSelector seed_selector_;
  std::vector<std::uint32_t> seeds_;
  std::vector<Centre> centre_, sum_;
  std::vector<float> distance_;  // of a cell to its owner
};

}  // namespace cleave::segmentation
