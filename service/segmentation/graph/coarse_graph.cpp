// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/coarse_graph.hpp"

#include <algorithm>
#include <bit>

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {
namespace {

constexpr float min_cosine = 0.98481F;  // 10 deg

bool is_smooth(const SupervoxelEdge& edge) {
  return edge.valid && !edge.is_cannot_link() && edge.cosine > min_cosine;
}

}  // namespace

void GraphCoarsener::match(const std::vector<SupervoxelEdge>& edges) {
  std::fill(is_matched_.begin(), is_matched_.end(), std::uint8_t{0});
  for (const std::uint64_t key : smooth_) {
    const auto e = static_cast<std::uint32_t>(key);
    const std::uint32_t a = joined_.root(edges[e].first);
    const std::uint32_t b = joined_.root(edges[e].second);
    if (a == b || is_matched_[a] != 0 || is_matched_[b] != 0) continue;
    joined_.join(a, b);
    is_matched_[a] = is_matched_[b] = 1;
  }
}

std::uint32_t GraphCoarsener::number_vertices() {
  std::uint32_t count = 0;
  vertex_.assign(joined_.size(), no_index);
  for (std::uint32_t s = 0; s < joined_.size(); ++s) {
    const std::uint32_t r = joined_.root(s);
    if (r == s) vertex_[s] = count++;
    vertex_[s] = vertex_[r];
  }
  return count;
}

void GraphCoarsener::add_up_edges(const std::vector<SupervoxelEdge>& edges,
                                  std::uint32_t vertices) {
  const int bits = std::bit_width(vertices);
  key_.clear();
  between_.clear();
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const auto [low, high] = std::minmax(vertex_[edges[e].first], vertex_[edges[e].second]);
    if (!edges[e].valid || low == high) continue;
    key_.push_back((std::uint64_t{low} << bits) | high);
    between_.push_back(e);
  }
  ranking_.rank(key_);
  edges_.clear();
  for (const std::uint64_t key : ranking_.distinct_keys()) {
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    edges_.push_back(
        {static_cast<std::uint32_t>(key >> bits), static_cast<std::uint32_t>(key & mask), 0, 0, 0});
  }
  for (std::size_t i = 0; i < between_.size(); ++i) {
    CutEdge& sum = edges_[ranking_.rank_of_item()[i]];
    const SupervoxelEdge& edge = edges[between_[i]];
    sum.weight += edge.weight;
    sum.cannot_links += edge.cannot_link_share;
    sum.cannot_link_weight += edge.cannot_link_share * edge.weight;
  }
}

std::uint32_t GraphCoarsener::coarsen(std::uint32_t supervoxels,
                                      const std::vector<SupervoxelEdge>& edges,
                                      std::uint32_t rounds) {
  joined_.reset(supervoxels);
  is_matched_.resize(supervoxels);
  smooth_.clear();
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!is_smooth(edges[e])) continue;
    // Bits of floats that are not negative sort as their values do.
    const auto bend = std::bit_cast<std::uint32_t>(std::max(2 - edges[e].cosine, 0.0F));
    smooth_.push_back((std::uint64_t{bend} << 32) | e);
  }
  std::sort(smooth_.begin(), smooth_.end());
  for (std::uint32_t round = 0; round < rounds; ++round) match(edges);
  const std::uint32_t vertices = number_vertices();
  add_up_edges(edges, vertices);
  return vertices;
}

}  // namespace cleave::segmentation
