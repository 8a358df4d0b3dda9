// SPDX-License-Identifier: BSD-3-Clause
// Normals and curvatures of voxels (section 2.1.2.2).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/graph/surfel.hpp"
#include "segmentation/math/moments.hpp"
#include "segmentation/math/neighbour_lists.hpp"

namespace cleave::segmentation {

// Fits a plane to the centroids of two rings of neighbours around every voxel.
class NormalEstimator {
 public:
  // A centroid counts once for every way to it of at most two steps, standing still being a step:
  // near ones count more. Unit normals towards the sensor; see fit_normal for lone voxels.
  void estimate(const std::vector<Eigen::Vector3f>& centroid, const NeighbourLists& neighbours,
                std::vector<Surfel>& surfels);
  // Surface variation (equation 2.2) of the same centroids; needs estimate() before.
  void estimate_curvature(const NeighbourLists& neighbours, std::vector<float>& curvature) const;

 private:
  std::vector<Moments> own_, one_ring_;
};

}  // namespace cleave::segmentation
