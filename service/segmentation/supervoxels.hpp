// The patches of surface that everything after the clustering works on.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/moments.hpp"
#include "segmentation/surfel.hpp"
#include "segmentation/voxel_grid.hpp"

namespace cleave::segmentation {

struct Supervoxels {
  std::vector<std::uint32_t> of_voxel;
  std::vector<Surfel> surfel;              // centroid and normal (section 4.1.2.1)
  std::vector<std::uint32_t> point_count;  // of a supervoxel

  [[nodiscard]] std::size_t size() const { return surfel.size(); }
};

// Fits a plane to each supervoxel; needs `of_voxel`, fills the rest.
class SupervoxelFitter {
 public:
  // `from_points`: through all its points; otherwise through its voxels, as in the thesis. One that
  // is too small for a plane gets the mean normal of its voxels.
  void fit(const VoxelGrid& grid, const std::vector<Surfel>& voxels, std::size_t count,
           bool from_points, Supervoxels& supervoxels);

 private:
  struct Sums {
    Moments moments;
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  };
  std::vector<Sums> sums_;
};

}  // namespace cleave::segmentation
