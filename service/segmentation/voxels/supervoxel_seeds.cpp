// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/supervoxel_seeds.hpp"

#include "segmentation/math/cell_packing.hpp"

namespace cleave::segmentation {

void SeedSelector::select(const std::vector<Surfel>& voxels, const SupervoxelOptions& options,
                          std::vector<std::uint32_t>& seeds) {
  const std::size_t count = voxels.size();
  const float cells_per_m = 1 / options.seed_spacing_m;
  for (auto* axis : {&x_, &y_, &z_}) axis->resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const Eigen::Vector3f p = voxels[v].position * cells_per_m;
    x_[v] = cell_of(p.x());
    y_[v] = cell_of(p.y());
    z_[v] = cell_of(p.z());
  }
  const CellPacking packing = CellPacking::covering(x_, y_, z_);
  key_.resize(count);
  for (std::size_t v = 0; v < count; ++v) key_[v] = packing.key(x_[v], y_[v], z_[v]);
  ranking_.rank(key_);

  cells_.assign(ranking_.distinct_keys().size(), Cell{});
  for (std::uint32_t v = 0; v < count; ++v) {
    Cell& cell = cells_[ranking_.rank_of_item()[v]];
    const Eigen::Vector3f middle =
        (Eigen::Vector3f(static_cast<float>(x_[v]), static_cast<float>(y_[v]),
                         static_cast<float>(z_[v])) +
         Eigen::Vector3f::Constant(0.5F)) *
        options.seed_spacing_m;
    const float squared_distance = (voxels[v].position - middle).squaredNorm();
    if (cell.voxels++ == 0 || squared_distance < cell.nearest_squared_distance) {
      cell.nearest_voxel = v;
      cell.nearest_squared_distance = squared_distance;
    }
  }

  seeds.clear();
  for (const Cell& cell : cells_) {
    if (cell.voxels >= options.min_seed_voxels) seeds.push_back(cell.nearest_voxel);
  }
}

}  // namespace cleave::segmentation
