// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 2: the best of all bipartitions that the eigenvectors induce.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/subgraphs.hpp"
#include "segmentation/partition/cut_finder.hpp"

namespace cleave::segmentation {

// Utility is that of equation 4.8: 0 without a cut across a cannot-link edge. A graph whose soft
// constraints do not amount to half a cannot-link edge is not cut.
class BestCutFinder final : public CutFinder {
 public:
  [[nodiscard]] bool may_cut(const SubgraphStore& store, const Subgraph& graph) const override {
    return store.cannot_links(graph) >= 0.5;
  }
  // The cut of the highest utility, the earliest among equals. Every edge is added to the cut where
  // the order meets its first end and taken out where it meets the second, so one pass over the
  // edges and one over the vertices judge all cuts of an eigenvector.
  [[nodiscard]] Cut find(const SubgraphStore& store, const Subgraph& graph) override;
  // The same along one order, a single eigenvector.
  [[nodiscard]] Cut find_along(std::size_t order, const SubgraphStore& store,
                               const Subgraph& graph);

 private:
  void improve_along(std::size_t order, const SubgraphStore& store, const Subgraph& graph,
                     Cut& best);

  struct Change {
    double weight = 0;
    double cannot_links = 0;
  };
  std::vector<std::uint32_t> rank_;  // of a vertex
  std::vector<Change> change_;       // of the cut, a position
};

}  // namespace cleave::segmentation
