// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/clean_up.hpp"

#include <algorithm>
#include <functional>

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {
namespace {
constexpr double weak_share = 0.5;        // of a border's length that links: see the class
constexpr std::uint32_t pair_factor = 4;  // times weak_border_points, of both of a pair
}  // namespace

void SmallSegmentMerger::list_edges_of_supervoxels(const std::vector<SupervoxelEdge>& edges,
                                                   std::size_t supervoxels) {
  edge_begin_.assign(supervoxels + 1, 0);
  for (const SupervoxelEdge& edge : edges) {
    ++edge_begin_[edge.first];
    ++edge_begin_[edge.second];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& row : edge_begin_) row = end += row;
  edge_of_.resize(end);
  for (auto e = static_cast<std::uint32_t>(edges.size()); e-- > 0;) {
    edge_of_[--edge_begin_[edges[e].first]] = e;
    edge_of_[--edge_begin_[edges[e].second]] = e;
  }
}

void SmallSegmentMerger::list_members(const std::vector<std::uint32_t>& segment,
                                      std::uint32_t segments) {
  first_.assign(segments, no_index);
  last_.assign(segments, no_index);
  next_.assign(segment.size(), no_index);
  for (std::uint32_t s = 0; s < segment.size(); ++s) {
    std::uint32_t& last = last_[segment[s]];
    (last == no_index ? first_[segment[s]] : next_[last]) = s;
    last = s;
  }
}

SmallSegmentMerger::Neighbour SmallSegmentMerger::closest_neighbour(
    const std::vector<SupervoxelEdge>& edges, const std::vector<std::uint32_t>& segment,
    std::uint32_t small) {
  bonded_.clear();
  for (std::uint32_t s = first_[small]; s != no_index; s = next_[s]) {
    for (std::uint32_t e = edge_begin_[s]; e < edge_begin_[s + 1]; ++e) {
      const SupervoxelEdge& edge = edges[edge_of_[e]];
      const std::uint32_t other = segment[edge.first == s ? edge.second : edge.first];
      if (other == small) continue;
      Bond& bond = bond_[other];
      if (bond.touching_voxels == 0) bonded_.push_back(other);
      bond.touching_voxels += edge.touching_voxels;
      if (!edge.valid) continue;
      bond.weight += edge.weight;
      if (!edge.is_cannot_link()) bond.linking_voxels += edge.touching_voxels;
    }
  }
  std::uint32_t best = no_index;
  for (const std::uint32_t other : bonded_) {
    const auto closeness = [&](std::uint32_t s) {
      return std::make_tuple(bond_[s].weight, bond_[s].touching_voxels, ~s);
    };
    if (best == no_index || closeness(other) > closeness(best)) best = other;
  }
  const bool weakly_parted =
      best != no_index && bond_[best].linking_voxels > weak_share * bond_[best].touching_voxels;
  for (const std::uint32_t other : bonded_) bond_[other] = Bond{};
  return {best, weakly_parted};
}

bool SmallSegmentMerger::should_join(std::uint32_t small, const Neighbour& neighbour,
                                     const CleanUpOptions& options) const {
  if (neighbour.segment == no_index) return false;
  if (points_[small] < options.min_segment_points) return true;
  if (!neighbour.weakly_parted) return false;
  return points_[small] < options.weak_border_points ||
         points_[neighbour.segment] < std::uint64_t{pair_factor} * options.weak_border_points;
}

void SmallSegmentMerger::join(std::uint32_t small, std::uint32_t into,
                              std::vector<std::uint32_t>& segment) {
  for (std::uint32_t s = first_[small]; s != no_index; s = next_[s]) segment[s] = into;
  next_[last_[into]] = first_[small];
  last_[into] = last_[small];
  points_[into] += points_[small];
  points_[small] = 0;
}

void SmallSegmentMerger::merge(const std::vector<SupervoxelEdge>& edges,
                               const std::vector<std::uint32_t>& points_of_supervoxel,
                               std::uint32_t segments, const CleanUpOptions& options,
                               std::vector<std::uint32_t>& segment) {
  const std::uint64_t may_join = std::max<std::uint64_t>(
      options.min_segment_points, std::uint64_t{pair_factor} * options.weak_border_points);
  list_edges_of_supervoxels(edges, segment.size());
  list_members(segment, segments);
  bond_.assign(segments, Bond{});
  points_.assign(segments, 0);
  for (std::size_t s = 0; s < segment.size(); ++s) points_[segment[s]] += points_of_supervoxel[s];

  heap_.clear();
  const auto push_if_small = [&](std::uint32_t s) {
    if (points_[s] >= may_join) return;
    heap_.emplace_back(points_[s], s);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  };
  for (std::uint32_t s = 0; s < segments; ++s) push_if_small(s);

  while (!heap_.empty()) {
    const auto [size, small] = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
    if (points_[small] != size) continue;  // it has grown, or joined another, since it was pushed
    const Neighbour neighbour = closest_neighbour(edges, segment, small);
    if (!should_join(small, neighbour, options)) continue;
    join(small, neighbour.segment, segment);
    push_if_small(neighbour.segment);
  }
}

}  // namespace cleave::segmentation
