// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/normals.hpp"

#include "segmentation/math/plane_fit.hpp"

namespace cleave::segmentation {
namespace {

Moments sum_over_ring(const std::vector<Moments>& moments, const NeighbourLists& neighbours,
                      std::size_t voxel) {
  Moments sum = moments[voxel];
  for (const std::uint32_t u : neighbours[voxel]) sum += moments[u];
  return sum;
}

}  // namespace

void NormalEstimator::estimate(const std::vector<Eigen::Vector3f>& centroid,
                               const NeighbourLists& neighbours, std::vector<Surfel>& surfels) {
  const std::size_t count = centroid.size();
  own_.assign(count, Moments{});
  one_ring_.resize(count);
  surfels.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    own_[v].add_point(centroid[v].x(), centroid[v].y(), centroid[v].z());
  }
  for (std::size_t v = 0; v < count; ++v) one_ring_[v] = sum_over_ring(own_, neighbours, v);
  for (std::size_t v = 0; v < count; ++v) {
    surfels[v] = {centroid[v], fit_normal(sum_over_ring(one_ring_, neighbours, v))};
  }
}

void NormalEstimator::estimate_curvature(const NeighbourLists& neighbours,
                                         std::vector<float>& curvature) const {
  curvature.resize(one_ring_.size());
  for (std::size_t v = 0; v < one_ring_.size(); ++v) {
    curvature[v] = surface_variation(sum_over_ring(one_ring_, neighbours, v));
  }
}

}  // namespace cleave::segmentation
