// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 3: the best of all bipartitions that the eigenvectors induce, by edge potentials.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/partition/cut_finder.hpp"

namespace cleave::segmentation {

// Utility is that of equation 4.19: potential (4.18) of the cut by its weight. Eigenvectors are
// scaled to lie between 0 and 1 in the graph that was decomposed, as in Figure 4.6: a unit vector's
// potentials would shrink as the graph grows.
class PotentialCutFinder final : public CutFinder {
 public:
  // Cuts that would leave fewer vertices on one side are not considered: they say nothing at the
  // scale of voxels, and without them there are at most so many cuts as fit. 1: all are.
  void set_least_vertices(std::uint32_t vertices) { least_vertices_ = vertices; }

  [[nodiscard]] bool may_cut(const SubgraphStore& store, const Subgraph& graph) const override;
  void decomposed(const SubgraphStore& store, const Subgraph& graph,
                  const Eigen::Ref<const Eigen::MatrixXd>& vectors) override;
  // The cut of the highest utility, the earliest among equals.
  [[nodiscard]] Cut find(const SubgraphStore& store, const Subgraph& graph) override;

 private:
  struct Change {
    double weight = 0;
    double potential = 0;
  };
  std::uint32_t least_vertices_ = 1;
  std::vector<std::vector<double>> value_;  // of an eigenvector, a vertex of the whole
  std::vector<std::uint32_t> rank_;         // of a vertex
  std::vector<Change> change_;              // of the cut, a position
};

}  // namespace cleave::segmentation
