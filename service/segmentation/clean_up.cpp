#include "segmentation/clean_up.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace cleave::segmentation {
namespace {
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
}

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
  first_.assign(segments, none);
  last_.assign(segments, none);
  next_.assign(segment.size(), none);
  for (std::uint32_t s = 0; s < segment.size(); ++s) {
    std::uint32_t& last = last_[segment[s]];
    (last == none ? first_[segment[s]] : next_[last]) = s;
    last = s;
  }
}

std::uint32_t SmallSegmentMerger::closest_neighbour(const std::vector<SupervoxelEdge>& edges,
                                                    const std::vector<std::uint32_t>& segment,
                                                    std::uint32_t small) {
  bonded_.clear();
  for (std::uint32_t s = first_[small]; s != none; s = next_[s]) {
    for (std::uint32_t e = edge_begin_[s]; e < edge_begin_[s + 1]; ++e) {
      const SupervoxelEdge& edge = edges[edge_of_[e]];
      const std::uint32_t other = segment[edge.first == s ? edge.second : edge.first];
      if (other == small) continue;
      Bond& bond = bond_[other];
      if (bond.touching_voxels == 0) bonded_.push_back(other);
      bond.touching_voxels += edge.touching_voxels;
      if (edge.valid) bond.weight += edge.weight;
    }
  }
  std::uint32_t best = none;
  for (const std::uint32_t other : bonded_) {
    const auto closeness = [&](std::uint32_t s) {
      return std::make_tuple(bond_[s].weight, bond_[s].touching_voxels, ~s);
    };
    if (best == none || closeness(other) > closeness(best)) best = other;
  }
  for (const std::uint32_t other : bonded_) bond_[other] = Bond{};
  return best;
}

void SmallSegmentMerger::join(std::uint32_t small, std::uint32_t into,
                              std::vector<std::uint32_t>& segment) {
  for (std::uint32_t s = first_[small]; s != none; s = next_[s]) segment[s] = into;
  next_[last_[into]] = first_[small];
  last_[into] = last_[small];
  points_[into] += points_[small];
  points_[small] = 0;
}

void SmallSegmentMerger::merge(const std::vector<SupervoxelEdge>& edges,
                               const std::vector<std::uint32_t>& points_of_supervoxel,
                               std::uint32_t segments, std::uint32_t min_points,
                               std::vector<std::uint32_t>& segment) {
  list_edges_of_supervoxels(edges, segment.size());
  list_members(segment, segments);
  bond_.assign(segments, Bond{});
  points_.assign(segments, 0);
  for (std::size_t s = 0; s < segment.size(); ++s) points_[segment[s]] += points_of_supervoxel[s];

  heap_.clear();
  const auto push_if_small = [&](std::uint32_t s) {
    if (points_[s] >= min_points) return;
    heap_.emplace_back(points_[s], s);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  };
  for (std::uint32_t s = 0; s < segments; ++s) push_if_small(s);

  while (!heap_.empty()) {
    const auto [size, small] = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
    if (points_[small] != size) continue;  // it has grown, or joined another, since it was pushed
    const std::uint32_t into = closest_neighbour(edges, segment, small);
    if (into == none) continue;
    join(small, into, segment);
    push_if_small(into);
  }
}

}  // namespace cleave::segmentation
