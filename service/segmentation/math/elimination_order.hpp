// SPDX-License-Identifier: BSD-3-Clause
// In which order to eliminate a graph's vertices so that few new edges arise.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/math/weighted_edge.hpp"

namespace cleave::segmentation {

// Approximate minimum degree (Amestoy, Davis and Duff, "Algorithm 837: AMD", 2004), by SuiteSparse.
// An order that is good for a graph is good for its subgraphs too. Deterministic; no allocation
// once warm.
class EliminationOrder {
 public:
  // Place of every vertex in the order. `edges`: without loops and parallels. The result is valid
  // until the next call.
  [[nodiscard]] std::span<const int> ranks(std::size_t vertices,
                                           std::span<const WeightedEdge> edges);

 private:
  void list_neighbours(std::span<const WeightedEdge> edges);

  std::vector<int> begin_, degree_, neighbours_;
  std::vector<int> rank_, vertex_at_;
  std::vector<int> nv_, head_, elen_, degrees_, w_;  // AMD's own
};

}  // namespace cleave::segmentation
