// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/subgraphs.hpp"

#include <algorithm>
#include <numeric>

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {

void SubgraphStore::reset(std::uint32_t vertices, std::span<const CutEdge> edges,
                          std::vector<Subgraph>& parts) {
  vertex_.resize(vertices);
  std::iota(vertex_.begin(), vertex_.end(), 0U);
  edge_.assign(edges.begin(), edges.end());
  in_side_.assign(vertices, 0);
  connected_.reset(vertices);
  component_.resize(vertices);
  orders_ = 0;
  split({0, vertices, 0, static_cast<std::uint32_t>(edges.size())}, {}, parts);
}

std::span<const std::uint32_t> SubgraphStore::vertices(const Subgraph& graph) const {
  return {vertex_.data() + graph.vertex_begin, vertex_.data() + graph.vertex_end};
}

std::span<const CutEdge> SubgraphStore::edges(const Subgraph& graph) const {
  return {edge_.data() + graph.edge_begin, edge_.data() + graph.edge_end};
}

double SubgraphStore::cannot_links(const Subgraph& graph) const {
  double sum = 0;
  for (const CutEdge& edge : edges(graph)) sum += edge.cannot_links;
  return sum;
}

std::span<const std::uint32_t> SubgraphStore::order(std::size_t k, const Subgraph& graph) const {
  const std::uint32_t* row = order_.data() + k * vertex_.size();
  return {row + graph.vertex_begin, row + graph.vertex_end};
}

void SubgraphStore::sort_along(const Eigen::Ref<const Eigen::MatrixXd>& vectors,
                               const Subgraph& graph) {
  orders_ = static_cast<std::size_t>(vectors.cols());
  order_.resize(orders_ * vertex_.size());
  keys_.resize(graph.vertices());
  for (std::size_t k = 0; k < orders_; ++k) {
    for (std::uint32_t i = 0; i < graph.vertices(); ++i) {
      keys_[i] = {vectors(i, static_cast<Eigen::Index>(k)), vertex_[graph.vertex_begin + i]};
    }
    std::sort(keys_.begin(), keys_.end(), [](const Key& l, const Key& r) {
      return l.value < r.value || (l.value == r.value && l.vertex < r.vertex);
    });
    std::uint32_t* row = order_.data() + k * vertex_.size() + graph.vertex_begin;
    for (const Key& key : keys_) *row++ = key.vertex;
  }
}

// Moves the edges that stay to the front and says where they end.
void SubgraphStore::drop_edges_across(const Subgraph& graph, std::uint32_t& edge_end) {
  const auto end =
      std::remove_if(edge_.begin() + graph.edge_begin, edge_.begin() + graph.edge_end,
                     [&](const CutEdge& e) { return in_side_[e.first] != in_side_[e.second]; });
  edge_end = static_cast<std::uint32_t>(end - edge_.begin());
}

// Numbers components in the order of their first vertices and appends ranges of the right sizes.
void SubgraphStore::find_components(const Subgraph& graph, std::size_t first_part,
                                    std::vector<Subgraph>& parts) {
  connected_.isolate(vertices(graph));
  for (const std::uint32_t v : vertices(graph)) component_[v] = no_index;
  for (const CutEdge& e : edges(graph)) connected_.join(e.first, e.second);
  for (const std::uint32_t v : vertices(graph)) {
    std::uint32_t& number = component_[connected_.root(v)];
    if (number == no_index) {
      number = static_cast<std::uint32_t>(parts.size() - first_part);
      parts.emplace_back();
    }
    component_[v] = number;
    ++parts[first_part + number].vertex_end;
  }
  for (const CutEdge& e : edges(graph)) ++parts[first_part + component_[e.first]].edge_end;

  std::uint32_t vertex = graph.vertex_begin;
  std::uint32_t edge = graph.edge_begin;
  for (std::size_t p = first_part; p < parts.size(); ++p) {
    parts[p] = {vertex, vertex + parts[p].vertex_end, edge, edge + parts[p].edge_end};
    vertex = parts[p].vertex_end;
    edge = parts[p].edge_end;
  }
}

// Stable counting sort of one permutation's part.
void SubgraphStore::group_by_component(std::span<std::uint32_t> vertices,
                                       std::span<const Subgraph> parts) {
  fill_.clear();
  for (const Subgraph& part : parts) fill_.push_back(part.vertex_begin - parts[0].vertex_begin);
  vertex_scratch_.assign(vertices.begin(), vertices.end());
  for (const std::uint32_t v : vertex_scratch_) vertices[fill_[component_[v]]++] = v;
}

void SubgraphStore::split(const Subgraph& graph, std::span<const std::uint32_t> side,
                          std::vector<Subgraph>& parts) {
  Subgraph rest = graph;
  for (const std::uint32_t v : side) in_side_[v] = 1;
  drop_edges_across(graph, rest.edge_end);
  for (const std::uint32_t v : side) in_side_[v] = 0;

  const std::size_t first_part = parts.size();
  find_components(rest, first_part, parts);
  const std::span<const Subgraph> found{parts.data() + first_part, parts.data() + parts.size()};
  if (found.size() < 2) return;

  for (std::size_t k = 0; k < orders_; ++k) {
    std::uint32_t* row = order_.data() + k * vertex_.size();
    group_by_component({row + graph.vertex_begin, row + graph.vertex_end}, found);
  }
  group_by_component({vertex_.data() + graph.vertex_begin, vertex_.data() + graph.vertex_end},
                     found);
  fill_.clear();
  for (const Subgraph& part : found) fill_.push_back(part.edge_begin);
  edge_scratch_.assign(edge_.begin() + rest.edge_begin, edge_.begin() + rest.edge_end);
  for (const CutEdge& e : edge_scratch_) edge_[fill_[component_[e.first]]++] = e;
}

}  // namespace cleave::segmentation
