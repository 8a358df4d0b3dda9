// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/spectral_cuts.hpp"

namespace cleave::segmentation {

void SpectralCutter::weigh(std::span<const CutEdge> edges, const SpectralSettings& settings) {
  weighted_edges_.clear();
  for (const CutEdge& edge : edges) {
    const double weight = settings.constrained
                              ? double{edge.weight} - double{edge.cannot_link_weight} -
                                    settings.cannot_link_weight * edge.cannot_links
                              : double{edge.weight};
    weighted_edges_.push_back({edge.first, edge.second, weight});
  }
}

void SpectralCutter::decompose(const Subgraph& graph, const SpectralSettings& settings,
                               CutFinder& finder) {
  weigh(store_.edges(graph), settings);
  const auto vectors = eigensolver_.solve(store_.vertices(graph), weighted_edges_,
                                          settings.eigenvectors, settings.laplacian);
  store_.sort_along(vectors, graph);
  finder.decomposed(store_, graph, vectors);
}

// The inner loop, lines 8 to 19. Leaves the parts in uncut_; false if the whole is the only one.
bool SpectralCutter::cut_along_orders(const Subgraph& graph, double utility_threshold,
                                      CutFinder& finder) {
  bool was_cut = false;
  uncut_.clear();
  active_.assign(1, graph);
  while (!active_.empty()) {
    const Subgraph part = active_.back();
    active_.pop_back();
    const Cut cut = finder.may_cut(store_, part) ? finder.find(store_, part) : Cut{};
    if (cut.utility > utility_threshold) {
      store_.split(part, store_.order(cut.order, part).first(cut.position), active_);
      was_cut = true;
    } else {
      uncut_.push_back(part);
    }
  }
  return was_cut;
}

void SpectralCutter::finish(const Subgraph& graph, std::vector<std::uint32_t>& segment_of_vertex) {
  for (const std::uint32_t v : store_.vertices(graph)) segment_of_vertex[v] = segments_;
  ++segments_;
}

std::uint32_t SpectralCutter::cut(std::uint32_t vertices, std::span<const CutEdge> edges,
                                  const SpectralSettings& settings, CutFinder& finder,
                                  std::vector<std::uint32_t>& segment_of_vertex) {
  segments_ = 0;
  segment_of_vertex.resize(vertices);
  weigh(edges, settings);
  eigensolver_.reset(vertices, weighted_edges_);
  queue_.clear();
  store_.reset(vertices, edges, queue_);

  while (!queue_.empty()) {
    const Subgraph graph = queue_.back();
    queue_.pop_back();
    if (!finder.may_cut(store_, graph)) {
      finish(graph, segment_of_vertex);
      continue;
    }
    decompose(graph, settings, finder);
    const bool was_cut = cut_along_orders(graph, settings.utility_threshold, finder);
    if (was_cut && settings.decomposition == Decomposition::recursive) {
      queue_.insert(queue_.end(), uncut_.begin(), uncut_.end());
    } else {
      for (const Subgraph& part : uncut_) finish(part, segment_of_vertex);
    }
  }
  return segments_;
}

}  // namespace cleave::segmentation
