#include "segmentation/partition.hpp"

namespace cleave::segmentation {

LaplacianEigensolver::Vectors Partitioner::eigenvectors(const Subgraph& graph,
                                                        std::uint32_t wanted) {
  weighted_edges_.clear();
  for (const CutEdge& edge : store_.edges(graph)) {
    weighted_edges_.push_back({edge.first, edge.second, edge.weight});
  }
  return eigensolver_.solve(store_.vertices(graph), weighted_edges_, wanted);
}

// The inner loop, lines 8 to 19. Leaves the parts in uncut_; false if the whole is the only one.
bool Partitioner::cut_along_orders(const Subgraph& graph, double utility_threshold) {
  bool was_cut = false;
  uncut_.clear();
  active_.assign(1, graph);
  while (!active_.empty()) {
    const Subgraph part = active_.back();
    active_.pop_back();
    const Cut cut = store_.has_cannot_link(part) ? best_cut_finder_.find(store_, part) : Cut{};
    if (cut.utility > utility_threshold) {
      store_.split(part, store_.order(cut.order, part).first(cut.position), active_);
      was_cut = true;
    } else {
      uncut_.push_back(part);
    }
  }
  return was_cut;
}

void Partitioner::finish(const Subgraph& graph) {
  for (const std::uint32_t v : store_.vertices(graph)) segment_of_vertex_[v] = segments_;
  ++segments_;
}

std::uint32_t Partitioner::partition(std::uint32_t supervoxels,
                                     const std::vector<SupervoxelEdge>& edges,
                                     const PartitionOptions& options,
                                     std::vector<std::uint32_t>& segment) {
  const std::uint32_t vertices = coarsener_.coarsen(supervoxels, edges, options.coarsening_rounds);
  segments_ = 0;
  segment_of_vertex_.resize(vertices);
  weighted_edges_.clear();
  for (const CutEdge& edge : coarsener_.edges()) {
    weighted_edges_.push_back({edge.first, edge.second, edge.weight});
  }
  eigensolver_.reset(vertices, weighted_edges_);
  queue_.clear();
  store_.reset(vertices, coarsener_.edges(), queue_);

  while (!queue_.empty()) {
    const Subgraph graph = queue_.back();
    queue_.pop_back();
    // Without a cannot-link edge no cut has a utility: the eigenproblem can be spared.
    if (!store_.has_cannot_link(graph)) {
      finish(graph);
      continue;
    }
    store_.sort_along(eigenvectors(graph, options.eigenvectors), graph);
    if (cut_along_orders(graph, options.utility_threshold)) {
      queue_.insert(queue_.end(), uncut_.begin(), uncut_.end());
    } else {
      finish(graph);
    }
  }
  segment.resize(supervoxels);
  for (std::uint32_t s = 0; s < supervoxels; ++s) {
    segment[s] = segment_of_vertex_[coarsener_.vertex_of_supervoxel()[s]];
  }
  return segments_;
}

}  // namespace cleave::segmentation
