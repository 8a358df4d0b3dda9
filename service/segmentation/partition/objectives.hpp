// SPDX-License-Identifier: BSD-3-Clause
// How good a partition of a weighted graph is (sections 2.2.1, 2.3.1 and 4.1.4): what spectral
// clustering relaxes, for tests, studies and comparisons.
#pragma once

#include <cstdint>
#include <span>

#include "segmentation/math/weighted_edge.hpp"

namespace cleave::segmentation {

// Vertices are 0 to cluster.size() - 1, and cluster[v] is below `clusters`; each edge is listed
// once. The degree of a cluster (2.4) counts each inner edge from both of its ends, as x^T A x of
// equation 2.20 does: only then is NAssociation = k - NCut. A ratio is 0 where both of its sides
// are, and infinite where only the divisor is. Deterministic; allocates.
struct PartitionedGraph {
  std::span<const WeightedEdge> edges;
  std::span<const std::uint32_t> cluster;
  std::uint32_t clusters = 0;
};

[[nodiscard]] double cut_size(const PartitionedGraph& graph);                // 2.9; minimum cut
[[nodiscard]] double ratio_cut(const PartitionedGraph& graph);               // 2.15
[[nodiscard]] double ratio_association(const PartitionedGraph& graph);       // 2.16; to maximise
[[nodiscard]] double normalised_cut(const PartitionedGraph& graph);          // 2.17
[[nodiscard]] double normalised_association(const PartitionedGraph& graph);  // 2.18; to maximise
[[nodiscard]] double min_max_cut(const PartitionedGraph& graph);             // 2.19

// Of a graph with negative weights and two clusters.
[[nodiscard]] double signed_cut(const PartitionedGraph& graph);        // 4.12, from 4.10 and 4.11
[[nodiscard]] double signed_ratio_cut(const PartitionedGraph& graph);  // 4.13

}  // namespace cleave::segmentation
