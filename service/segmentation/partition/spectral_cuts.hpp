// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 on any graph, with any way to find the best cut.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/graph/subgraphs.hpp"
#include "segmentation/options.hpp"
#include "segmentation/partition/cut_finder.hpp"
#include "segmentation/partition/eigenvectors.hpp"

namespace cleave::segmentation {

struct SpectralSettings {
  std::uint32_t eigenvectors = 10;  // k
  double utility_threshold = 0;     // line 13: a cut must be better
  Decomposition decomposition = Decomposition::recursive;
  LaplacianKind laplacian;
  // Constrained clustering (section 4.1.4): in the Laplacian every cannot-link edge weighs minus
  // this, whatever its weight in the cut; without it, what it weighs.
  bool constrained = false;
  double cannot_link_weight = 1;
};

// Reuses its memory: no allocation once warm. Deterministic.
class SpectralCutter {
 public:
  // Gives every vertex a segment, numbered from 0 without gaps, and returns their number. The
  // graph need not be connected: its components are decomposed one by one, as the blocks of the
  // Laplacian that they are.
  std::uint32_t cut(std::uint32_t vertices, std::span<const CutEdge> edges,
                    const SpectralSettings& settings, CutFinder& finder,
                    std::vector<std::uint32_t>& segment_of_vertex);

 private:
  void weigh(std::span<const CutEdge> edges, const SpectralSettings& settings);
  void decompose(const Subgraph& graph, const SpectralSettings& settings, CutFinder& finder);
  bool cut_along_orders(const Subgraph& graph, double utility_threshold, CutFinder& finder);
  void finish(const Subgraph& graph, std::vector<std::uint32_t>& segment_of_vertex);

  LaplacianEigensolver eigensolver_;
  SubgraphStore store_;
  std::uint32_t segments_ = 0;
  std::vector<Subgraph> queue_;   // Q: subgraphs that are to be decomposed
  std::vector<Subgraph> active_;  // A: parts that are still cut along the current eigenvectors
  std::vector<Subgraph> uncut_;   // parts that the current eigenvectors do not cut any more
  std::vector<WeightedEdge> weighted_edges_;
};

}  // namespace cleave::segmentation
