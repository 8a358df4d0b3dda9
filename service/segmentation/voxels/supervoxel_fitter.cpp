// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/supervoxel_fitter.hpp"

#include "segmentation/math/plane_fit.hpp"

namespace cleave::segmentation {
namespace {

// Fewer do not tell the plane from their noise.
constexpr double min_points_for_plane = 10;
constexpr double min_voxels_for_plane = 4;

}  // namespace

void SupervoxelFitter::fit(const VoxelGrid& grid, const std::vector<Surfel>& voxels,
                           std::size_t count, bool from_points, Supervoxels& supervoxels) {
  sums_.assign(count, Sums{});
  supervoxels.surfel.resize(count);
  supervoxels.point_count.assign(count, 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    Sums& sums = sums_[supervoxels.of_voxel[v]];
    const Eigen::Vector3f& p = voxels[v].position;
    if (from_points) {
      sums.moments += grid.moments[v];
    } else {
      sums.moments.add_point(p.x(), p.y(), p.z());
    }
    sums.normal += voxels[v].normal;
    supervoxels.point_count[supervoxels.of_voxel[v]] +=
        static_cast<std::uint32_t>(grid.moments[v].n);
  }

  const double enough = from_points ? min_points_for_plane : min_voxels_for_plane;
  for (std::size_t s = 0; s < count; ++s) {
    Surfel& surfel = supervoxels.surfel[s];
    surfel.position = sums_[s].moments.mean().cast<float>();
    surfel.normal = sums_[s].moments.n >= enough
                        ? fit_normal(sums_[s].moments)
                        : unit_or_towards_sensor(sums_[s].normal, surfel.position);
  }
}

}  // namespace cleave::segmentation
