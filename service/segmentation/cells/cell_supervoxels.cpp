// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_supervoxels.hpp"

#include "segmentation/cells/cell_clustering.hpp"
#include "segmentation/math/plane_fit.hpp"

namespace cleave::segmentation {
namespace {
// Of the covariance of (u, v), determinant to squared trace: below, the cells lie on a line.
constexpr double min_plane_spread_ratio = 1e-3;
}  // namespace

void CellSupervoxelFitter::fit(const CellImage& cells, const std::vector<std::uint32_t>& supervoxel,
                               std::size_t count, bool from_points, Supervoxels& supervoxels) {
  sums_.assign(count, Sums{});
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    for (std::size_t i = begin; i < begin + cells.columns; ++i) {
      if (supervoxel[i] == CellClusterer::no_owner) continue;
      Sums& sum = sums_[supervoxel[i]];
      const double points = cells.points[i];
      const double weight = from_points ? points : 1;
      const double u = cells.u[i];
      const double v = cells.v[i];
      const double q = cells.inverse_depth[i];
      sum.points += points;
      sum.weight += weight;
      sum.x += weight * cells.x[i];
      sum.y += weight * cells.y[i];
      sum.z += weight * cells.z[i];
      sum.u += weight * u;
      sum.v += weight * v;
      sum.q += weight * q;
      sum.uu += weight * u * u;
      sum.uv += weight * u * v;
      sum.vv += weight * v * v;
      sum.uq += weight * u * q;
      sum.vq += weight * v * q;
      sum.normal += Eigen::Vector3f(cells.normal_x[i], cells.normal_y[i], cells.normal_z[i]);
    }
  }

  supervoxels.surfel.resize(count);
  supervoxels.point_count.resize(count);
  for (std::size_t s = 0; s < count; ++s) {
    const Sums& sum = sums_[s];
    const double share = 1 / sum.weight;
    const double uu = sum.uu - sum.u * sum.u * share;
    const double uv = sum.uv - sum.u * sum.v * share;
    const double vv = sum.vv - sum.v * sum.v * share;
    const double uq = sum.uq - sum.u * sum.q * share;
    const double vq = sum.vq - sum.v * sum.q * share;
    const double determinant = uu * vv - uv * uv;
    const double trace = uu + vv;

    Surfel& surfel = supervoxels.surfel[s];
    surfel.position = (Eigen::Vector3d(sum.x, sum.y, sum.z) * share).cast<float>();
    supervoxels.point_count[s] = static_cast<std::uint32_t>(sum.points);
    if (determinant > min_plane_spread_ratio * trace * trace) {
      const double a = (uq * vv - vq * uv) / determinant;
      const double b = (vq * uu - uq * uv) / determinant;
      const double c = (sum.q - a * sum.u - b * sum.v) * share;
      surfel.normal = -Eigen::Vector3d(a, b, c).normalized().cast<float>();
    } else {
      surfel.normal = unit_or_towards_sensor(sum.normal, surfel.position);
    }
  }
}

}  // namespace cleave::segmentation
