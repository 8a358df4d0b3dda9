// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/voxels/supervoxel_clustering.hpp"

#include <algorithm>
#include <array>

namespace cleave::segmentation {
namespace {
constexpr std::uint32_t default_sweeps = 6;  // after them hardly a voxel changes hands
}  // namespace

void SupervoxelClusterer::plant_seeds(const std::vector<Surfel>& voxels) {
  owner_.assign(voxels.size(), unowned);
  centre_.clear();
  for (const std::uint32_t voxel : seeds_) {
    owner_[voxel] = static_cast<std::uint32_t>(centre_.size());
    centre_.push_back(voxels[voxel]);
  }
}

std::uint32_t SupervoxelClusterer::best_owner(std::uint32_t voxel, const Surfel& surfel,
                                              const NeighbourLists& neighbours,
                                              const SupervoxelMetric& distance) const {
  std::uint32_t best = owner_[voxel];
  float best_distance = -1;  // not computed yet: most voxels have one owner all around
  std::uint32_t last_seen = best;
  for (const std::uint32_t u : neighbours[voxel]) {
    const std::uint32_t candidate = owner_[u];
    if (candidate == unowned || candidate == last_seen || candidate == best) continue;
    last_seen = candidate;
    if (best_distance < 0) {
      best_distance = best == unowned ? std::numeric_limits<float>::infinity()
                                      : distance(surfel, centre_[best]);
    }
    const float candidate_distance = distance(surfel, centre_[candidate]);
    if (candidate_distance < best_distance) {
      best_distance = candidate_distance;
      best = candidate;
    }
  }
  return best;
}

SupervoxelClusterer::Change SupervoxelClusterer::sweep(const std::vector<Surfel>& voxels,
                                                       const NeighbourLists& neighbours,
                                                       const SupervoxelMetric& distance) {
  Change change;
  next_owner_.resize(voxels.size());
  for (std::uint32_t v = 0; v < voxels.size(); ++v) {
    next_owner_[v] = best_owner(v, voxels[v], neighbours, distance);
    if (next_owner_[v] == owner_[v]) continue;
    change.any = true;
    change.grew = change.grew || owner_[v] == unowned;
  }
  owner_.swap(next_owner_);
  return change;
}

void SupervoxelClusterer::move_centres(const std::vector<Surfel>& voxels) {
  std::fill(centre_.begin(), centre_.end(), Surfel{});
  voxels_in_centre_.assign(centre_.size(), 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (owner_[v] == unowned) continue;
    Surfel& centre = centre_[owner_[v]];
    centre.position += voxels[v].position;
    centre.normal += voxels[v].normal;
    voxels_in_centre_[owner_[v]] += 1;
  }
  for (std::size_t s = 0; s < centre_.size(); ++s) {
    if (voxels_in_centre_[s] == 0) continue;
    centre_[s].position /= voxels_in_centre_[s];
    centre_[s].normal.normalize();
  }
}

// Voxels that no seed can reach: one supervoxel an island.
void SupervoxelClusterer::own_islands(const NeighbourLists& neighbours) {
  for (std::uint32_t v = 0; v < owner_.size(); ++v) {
    if (owner_[v] != unowned) continue;
    const auto island = static_cast<std::uint32_t>(centre_.size());
    centre_.emplace_back();
    owner_[v] = island;
    stack_.assign(1, v);
    while (!stack_.empty()) {
      const std::uint32_t from = stack_.back();
      stack_.pop_back();
      for (const std::uint32_t u : neighbours[from]) {
        if (owner_[u] != unowned) continue;
        owner_[u] = island;
        stack_.push_back(u);
      }
    }
  }
}

std::uint32_t SupervoxelClusterer::cluster(const std::vector<Surfel>& voxels,
                                           const NeighbourLists& neighbours,
                                           const SupervoxelOptions& options,
                                           std::vector<std::uint32_t>& supervoxel_of_voxel) {
  const SupervoxelMetric distance(options);
  seed_selector_.select(voxels, options, seeds_);
  plant_seeds(voxels);

  const std::uint32_t sweeps = options.sweeps > 0 ? options.sweeps : default_sweeps;
  Change change{.any = true, .grew = true};
  for (std::uint32_t i = 0; change.any && (i < sweeps || change.grew); ++i) {
    change = sweep(voxels, neighbours, distance);
    move_centres(voxels);
  }
  own_islands(neighbours);
  move_centres(voxels);

  return fragment_mender_.mend(voxels, neighbours, centre_, distance, owner_, supervoxel_of_voxel);
}

}  // namespace cleave::segmentation
