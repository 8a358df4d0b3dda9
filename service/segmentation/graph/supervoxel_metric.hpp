// SPDX-License-Identifier: BSD-3-Clause
// How far a voxel is from a supervoxel.
#pragma once

#include "segmentation/graph/surfel.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// The distance of Papon et al. without its colour term: position in seed spacings, and how much the
// normals differ, each with its weight.
class SupervoxelMetric {
 public:
  explicit SupervoxelMetric(const SupervoxelOptions& options)
      : per_metre_(options.spatial_weight / options.seed_spacing_m),
        normal_weight_(options.normal_weight) {}

  [[nodiscard]] float operator()(const Surfel& a, const Surfel& b) const {
    return normal_weight_ * (1 - a.normal.dot(b.normal)) +
           per_metre_ * (a.position - b.position).norm();
  }

 private:
  float per_metre_;
  float normal_weight_;
};

}  // namespace cleave::segmentation
