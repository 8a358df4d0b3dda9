// SPDX-License-Identifier: BSD-3-Clause
// The patches of surface that everything after the clustering works on.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/surfel.hpp"

namespace cleave::segmentation {

struct Supervoxels {
  std::vector<std::uint32_t> of_voxel;
  std::vector<Surfel> surfel;              // centroid and normal (section 4.1.2.1)
  std::vector<std::uint32_t> point_count;  // of a supervoxel

  [[nodiscard]] std::size_t size() const { return surfel.size(); }
};

}  // namespace cleave::segmentation
