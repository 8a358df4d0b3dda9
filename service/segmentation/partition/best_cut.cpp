// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/best_cut.hpp"

#include <algorithm>

namespace cleave::segmentation {
namespace {
// Added and removed weights leave rounding behind; no real cut weighs as little.
constexpr double min_cut_weight = 1e-9;
}  // namespace

void BestCutFinder::improve_along(std::size_t k, const SubgraphStore& store, const Subgraph& graph,
                                  Cut& best) {
  const auto order = store.order(k, graph);
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    if (order[i] >= rank_.size()) rank_.resize(order[i] + 1);
    rank_[order[i]] = i;
  }
  change_.assign(order.size(), Change{});
  for (const CutEdge& edge : store.edges(graph)) {
    const auto [low, high] = std::minmax(rank_[edge.first], rank_[edge.second]);
    change_[low].weight += edge.weight;
    change_[low].cannot_links += edge.cannot_links;
    change_[high].weight -= edge.weight;
    change_[high].cannot_links -= edge.cannot_links;
  }

  double weight = 0;        // equation 2.8
  double cannot_links = 0;  // exact: shares are multiples of 1/64
  for (std::uint32_t i = 0; i + 1 < order.size(); ++i) {
    weight += change_[i].weight;
    cannot_links += change_[i].cannot_links;
    const double utility = cannot_links / std::max(weight, min_cut_weight);
    if (utility > best.utility) best = {.order = k, .position = i + 1, .utility = utility};
  }
}

Cut BestCutFinder::find(const SubgraphStore& store, const Subgraph& graph) {
  Cut best;
  for (std::size_t k = 0; k < store.orders(); ++k) improve_along(k, store, graph, best);
  return best;
}

Cut BestCutFinder::find_along(std::size_t order, const SubgraphStore& store,
                              const Subgraph& graph) {
  Cut best;
  improve_along(order, store, graph, best);
  return best;
}

}  // namespace cleave::segmentation
