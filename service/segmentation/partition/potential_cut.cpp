// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/potential_cut.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::segmentation {
namespace {
// Added and removed weights leave rounding behind; no real cut weighs as little.
constexpr double min_potential_cut_weight = 1e-9;
}  // namespace

bool PotentialCutFinder::may_cut(const SubgraphStore& /*store*/, const Subgraph& graph) const {
  return graph.vertices() >= 2 && graph.vertices() >= std::uint64_t{2} * least_vertices_;
}

void PotentialCutFinder::decomposed(const SubgraphStore& store, const Subgraph& graph,
                                    const Eigen::Ref<const Eigen::MatrixXd>& vectors) {
  const auto vertices = store.vertices(graph);
  const std::uint32_t last = *std::max_element(vertices.begin(), vertices.end());
  rank_.resize(std::max<std::size_t>(rank_.size(), last + std::size_t{1}));
  value_.resize(std::max(value_.size(), static_cast<std::size_t>(vectors.cols())));
  for (Eigen::Index k = 0; k < vectors.cols(); ++k) {
    std::vector<double>& value = value_[static_cast<std::size_t>(k)];
    value.resize(rank_.size());
    const double least = vectors.col(k).minCoeff();
    const double range = vectors.col(k).maxCoeff() - least;
    const double scale = range > 0 ? 1 / range : 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      value[vertices[i]] = (vectors(static_cast<Eigen::Index>(i), k) - least) * scale;
    }
  }
}

Cut PotentialCutFinder::find(const SubgraphStore& store, const Subgraph& graph) {
  Cut best;
  for (std::size_t k = 0; k < store.orders(); ++k) {
    const auto order = store.order(k, graph);
    const std::vector<double>& value = value_[k];
    for (std::uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i;
    change_.assign(order.size(), Change{});
    for (const CutEdge& edge : store.edges(graph)) {
      const auto [low, high] = std::minmax(rank_[edge.first], rank_[edge.second]);
      const double potential = std::abs(value[edge.first] - value[edge.second]);  // equation 4.17
      change_[low].weight += edge.weight;
      change_[low].potential += potential;
      change_[high].weight -= edge.weight;
      change_[high].potential -= potential;
    }

    double weight = 0;     // equation 2.8
    double potential = 0;  // equation 4.18
    const auto size = static_cast<std::uint32_t>(order.size());
    for (std::uint32_t i = 0; i + 1 < size; ++i) {
      weight += change_[i].weight;
      potential += change_[i].potential;
      if (i + 1 < least_vertices_ || size - i - 1 < least_vertices_) continue;
      const double utility = potential / std::max(weight, min_potential_cut_weight);
      if (utility > best.utility) best = {.order = k, .position = i + 1, .utility = utility};
    }
  }
  return best;
}

}  // namespace cleave::segmentation
