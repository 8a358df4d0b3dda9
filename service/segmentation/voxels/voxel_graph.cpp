// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/voxel_graph.hpp"

namespace cleave::segmentation {
namespace {

float inverse_quadratic(float squared_difference, float sigma) {
  return 1 / (1 + sigma * squared_difference);
}

}  // namespace

void find_convex_voxels(const std::vector<Surfel>& voxels, const NeighbourLists& neighbours,
                        std::vector<std::uint8_t>& is_convex) {
  is_convex.resize(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    int balance = 0;
    for (const std::uint32_t j : neighbours[i]) {
      const float lean = (voxels[j].position - voxels[i].position).dot(voxels[j].normal);
      balance += lean > 0 ? 1 : lean < 0 ? -1 : 0;
    }
    is_convex[i] = balance > 0 ? 1 : 0;
  }
}

float concave_voxel_weight(const Surfel& i, const Surfel& j, float c_i, float c_j,
                           const SvcOptions& options) {
  const float curvatures = c_i * c_j;
  return inverse_quadratic((i.normal - j.normal).squaredNorm(), options.normal_sigma) *
         inverse_quadratic(curvatures * curvatures, options.curvature_sigma);
}

void VoxelGraphBuilder::build(const std::vector<Surfel>& voxels,
                              const std::vector<float>& curvature, const NeighbourLists& neighbours,
                              const SvcOptions& options, std::vector<SupervoxelEdge>& edges) {
  find_convex_voxels(voxels, neighbours, is_convex_);
  edges.clear();
  for (std::uint32_t i = 0; i < voxels.size(); ++i) {
    for (const std::uint32_t j : neighbours[i]) {
      if (j < i) continue;
      const bool convex = is_convex_[i] != 0 && is_convex_[j] != 0;
      edges.push_back({.first = i,
                       .second = j,
                       .touching_voxels = 1,
                       .weight = convex ? 1
                                        : concave_voxel_weight(voxels[i], voxels[j], curvature[i],
                                                               curvature[j], options),
                       .cosine = voxels[i].normal.dot(voxels[j].normal),
                       .convex = convex,
                       .valid = true});
    }
  }
}

}  // namespace cleave::segmentation
