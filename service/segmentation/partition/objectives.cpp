// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/objectives.hpp"

#include <cmath>
#include <vector>

namespace cleave::segmentation {
namespace {

struct ClusterSums {
  double vertices = 0;
  double cut = 0;                                               // Cut(C, rest), equation 2.8
  double degree = 0;                                            // deg(C), 2.4
  [[nodiscard]] double volume() const { return degree + cut; }  // 2.6
};

std::vector<ClusterSums> sums_of(const PartitionedGraph& graph) {
  std::vector<ClusterSums> sums(graph.clusters);
  for (const std::uint32_t c : graph.cluster) sums[c].vertices += 1;
  for (const WeightedEdge& edge : graph.edges) {
    const std::uint32_t a = graph.cluster[edge.first];
    const std::uint32_t b = graph.cluster[edge.second];
    if (a == b) {
      sums[a].degree += 2 * edge.weight;
    } else {
      sums[a].cut += edge.weight;
      sums[b].cut += edge.weight;
    }
  }
  return sums;
}

double ratio(double dividend, double divisor) {
  return dividend == 0 ? 0 : dividend / divisor;
}

template <class OfCluster>
double sum_over_clusters(const PartitionedGraph& graph, OfCluster&& of_cluster) {
  double sum = 0;
  for (const ClusterSums& c : sums_of(graph)) sum += of_cluster(c);
  return sum;
}

}  // namespace

double cut_size(const PartitionedGraph& graph) {
  return sum_over_clusters(graph, [](const ClusterSums& c) { return c.cut; }) / 2;
}

double ratio_cut(const PartitionedGraph& graph) {
  return sum_over_clusters(graph, [](const ClusterSums& c) { return ratio(c.cut, c.vertices); });
}

double ratio_association(const PartitionedGraph& graph) {
  return sum_over_clusters(graph, [](const ClusterSums& c) { return ratio(c.degree, c.vertices); });
}

double normalised_cut(const PartitionedGraph& graph) {
  return sum_over_clusters(graph, [](const ClusterSums& c) { return ratio(c.cut, c.volume()); });
}

double normalised_association(const PartitionedGraph& graph) {
  return sum_over_clusters(graph, [](const ClusterSums& c) { return ratio(c.degree, c.volume()); });
}

double min_max_cut(const PartitionedGraph& graph) {
  return sum_over_clusters(graph, [](const ClusterSums& c) { return ratio(c.cut, c.degree); });
}

double signed_cut(const PartitionedGraph& graph) {
  double sum = 0;
  for (const WeightedEdge& edge : graph.edges) {
    const bool across = graph.cluster[edge.first] != graph.cluster[edge.second];
    if (across == (edge.weight > 0)) sum += 2 * std::abs(edge.weight);
  }
  return sum;
}

double signed_ratio_cut(const PartitionedGraph& graph) {
  const auto sums = sums_of(graph);
  return signed_cut(graph) * (1 / sums[0].vertices + 1 / sums[1].vertices);
}

}  // namespace cleave::segmentation
