// SPDX-License-Identifier: BSD-3-Clause
// A graph that is cut again and again, in place: a subgraph is a range of vertices and of edges.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/math/union_find.hpp"

namespace cleave::segmentation {

struct CutEdge {
  std::uint32_t first = 0, second = 0;
  float weight = 0;
  float cannot_links = 0;        // how many edges of equation 4.7 it stands for, soft ones in part
  float cannot_link_weight = 0;  // what those are of the weight
};

// Valid for the SubgraphStore it is from, until that subgraph is split.
struct Subgraph {
  std::uint32_t vertex_begin = 0, vertex_end = 0;
  std::uint32_t edge_begin = 0, edge_end = 0;

  [[nodiscard]] std::uint32_t vertices() const { return vertex_end - vertex_begin; }
};

class SubgraphStore {
 public:
  // Takes a whole graph and appends its connected components to `parts`.
  void reset(std::uint32_t vertices, std::span<const CutEdge> edges, std::vector<Subgraph>& parts);

  [[nodiscard]] std::span<const std::uint32_t> vertices(const Subgraph& graph) const;
  [[nodiscard]] std::span<const CutEdge> edges(const Subgraph& graph) const;
  // The sum over its edges.
  [[nodiscard]] double cannot_links(const Subgraph& graph) const;

  // Sorts the subgraph's vertices along each column of `vectors`, ties by vertex; row i belongs to
  // vertices(graph)[i]. Parts that it is split into inherit the orders.
  void sort_along(const Eigen::Ref<const Eigen::MatrixXd>& vectors, const Subgraph& graph);
  [[nodiscard]] std::size_t orders() const { return orders_; }
  [[nodiscard]] std::span<const std::uint32_t> order(std::size_t k, const Subgraph& graph) const;

  // Cuts between the vertices of `side` and the others of `graph` and appends the connected
  // components of what is left to `parts`: at least two.
  void split(const Subgraph& graph, std::span<const std::uint32_t> side,
             std::vector<Subgraph>& parts);

 private:
  void drop_edges_across(const Subgraph& graph, std::uint32_t& edge_end);
  void find_components(const Subgraph& graph, std::size_t first_part, std::vector<Subgraph>& parts);
  void group_by_component(std::span<std::uint32_t> vertices, std::span<const Subgraph> parts);

  struct Key {
    double value;
    std::uint32_t vertex;
  };
  std::vector<std::uint32_t> vertex_;  // a permutation of all
  std::vector<CutEdge> edge_;
  std::size_t orders_ = 0;
  std::vector<std::uint32_t> order_;      // `orders_` more permutations, grouped like vertex_
  std::vector<std::uint8_t> in_side_;     // a vertex
  UnionFind connected_;                   // vertices
  std::vector<std::uint32_t> component_;  // a vertex
  std::vector<std::uint32_t> fill_, vertex_scratch_;
  std::vector<CutEdge> edge_scratch_;
  std::vector<Key> keys_;
};

}  // namespace cleave::segmentation
