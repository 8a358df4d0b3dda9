// Algorithm 1: Spectral Supervoxel Clustering.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/best_cut.hpp"
#include "segmentation/coarse_graph.hpp"
#include "segmentation/eigenvectors.hpp"
#include "segmentation/options.hpp"
#include "segmentation/subgraphs.hpp"
#include "segmentation/supervoxel_graph.hpp"

namespace cleave::segmentation {

class Partitioner {
 public:
  // Gives every supervoxel a segment, numbered from 0 without gaps, and returns their number. Only
  // valid edges connect and count. Supervoxels that coarsening has joined stay together.
  std::uint32_t partition(std::uint32_t supervoxels, const std::vector<SupervoxelEdge>& edges,
                          const PartitionOptions& options, std::vector<std::uint32_t>& segment);

 private:
  [[nodiscard]] LaplacianEigensolver::Vectors eigenvectors(const Subgraph& graph,
                                                           std::uint32_t wanted);
  bool cut_along_orders(const Subgraph& graph, double utility_threshold);
  void finish(const Subgraph& graph);

  GraphCoarsener coarsener_;
  LaplacianEigensolver eigensolver_;
  SubgraphStore store_;
  BestCutFinder best_cut_finder_;
  std::uint32_t segments_ = 0;
  std::vector<std::uint32_t> segment_of_vertex_;
  std::vector<Subgraph> queue_;   // Q: subgraphs that are to be decomposed
  std::vector<Subgraph> active_;  // A: parts that are still cut along the current eigenvectors
  std::vector<Subgraph> uncut_;   // parts that the current eigenvectors do not cut any more
  std::vector<WeightedEdge> weighted_edges_;
};

}  // namespace cleave::segmentation
