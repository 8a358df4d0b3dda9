// SPDX-License-Identifier: BSD-3-Clause
// A graph with fewer vertices and the same cuts worth making.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/graph/subgraphs.hpp"
#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/math/union_find.hpp"

namespace cleave::segmentation {

// Joins neighbouring supervoxels of one smooth surface before the graph is cut. Weights and
// cannot-link edges between the same two vertices add up, so every cut that is left has exactly the
// weight, the cannot-link edges and the utility that it has in the whole graph.
class GraphCoarsener {
 public:
  // `rounds` times each vertex is joined with at most one other, over valid edges that bend by less
  // than 10 degrees and are not cannot-link; the straightest first. Returns how many are left.
  std::uint32_t coarsen(std::uint32_t supervoxels, const std::vector<SupervoxelEdge>& edges,
                        std::uint32_t rounds);

  // Of the result: edges by (first, second), and the vertex of each supervoxel.
  [[nodiscard]] const std::vector<CutEdge>& edges() const { return edges_; }
  [[nodiscard]] const std::vector<std::uint32_t>& vertex_of_supervoxel() const { return vertex_; }

 private:
  void match(const std::vector<SupervoxelEdge>& edges);
  std::uint32_t number_vertices();
  void add_up_edges(const std::vector<SupervoxelEdge>& edges, std::uint32_t vertices);

  CellRanking ranking_;
  std::vector<std::uint64_t> smooth_;     // how far it bends, and the edge; straightest first
  UnionFind joined_;                      // supervoxels
  std::vector<std::uint8_t> is_matched_;  // in this round
  std::vector<std::uint32_t> vertex_;
  std::vector<std::uint64_t> key_;
  std::vector<std::uint32_t> between_;  // edges between different vertices
  std::vector<CutEdge> edges_;
};

}  // namespace cleave::segmentation
