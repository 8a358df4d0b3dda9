// SPDX-License-Identifier: BSD-3-Clause
// Over-segmentation into supervoxels: patches of voxels that are near and alike (section 4.1.1),
// after Voxel Cloud Connectivity Segmentation (Papon et al., CVPR 2013) without colour.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "segmentation/graph/supervoxel_metric.hpp"
#include "segmentation/graph/surfel.hpp"
#include "segmentation/math/neighbour_lists.hpp"
#include "segmentation/options.hpp"
#include "segmentation/voxels/supervoxel_fragments.hpp"
#include "segmentation/voxels/supervoxel_seeds.hpp"

namespace cleave::segmentation {

// Local k-means on the voxel graph: clusters grow from their seeds to neighbouring voxels only.
class SupervoxelClusterer {
 public:
  // Gives every voxel a supervoxel, numbered from 0 without gaps in the order of their first voxel;
  // every supervoxel is connected. Returns their number.
  std::uint32_t cluster(const std::vector<Surfel>& voxels, const NeighbourLists& neighbours,
                        const SupervoxelOptions& options,
                        std::vector<std::uint32_t>& supervoxel_of_voxel);

 private:
  static constexpr std::uint32_t unowned = std::numeric_limits<std::uint32_t>::max();
  struct Change {
    bool any = false;
    bool grew = false;  // a voxel that nobody owned got an owner
  };

  void plant_seeds(const std::vector<Surfel>& voxels);
  Change sweep(const std::vector<Surfel>& voxels, const NeighbourLists& neighbours,
               const SupervoxelMetric& distance);
  std::uint32_t best_owner(std::uint32_t voxel, const Surfel& surfel,
                           const NeighbourLists& neighbours,
                           const SupervoxelMetric& distance) const;
  void move_centres(const std::vector<Surfel>& voxels);
  void own_islands(const NeighbourLists& neighbours);

  SeedSelector seed_selector_;
  FragmentMender fragment_mender_;
  std::vector<std::uint32_t> seeds_;
  std::vector<std::uint32_t> owner_, next_owner_;  // a voxel
  std::vector<Surfel> centre_;                     // a supervoxel
  std::vector<float> voxels_in_centre_;
  std::vector<std::uint32_t> stack_;
};

}  // namespace cleave::segmentation
