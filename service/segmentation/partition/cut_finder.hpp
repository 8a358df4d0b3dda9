// SPDX-License-Identifier: BSD-3-Clause
// What differs between the methods that share Algorithm 1: which cut is the best.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "segmentation/graph/subgraphs.hpp"

namespace cleave::segmentation {

struct Cut {
  std::size_t order = 0;       // the eigenvector, as an order of SubgraphStore
  std::uint32_t position = 0;  // so many of its first vertices are one side
  double utility = 0;          // 0: there is no cut
};

class CutFinder {
 public:
  virtual ~CutFinder() = default;
  // False if no cut of it can have a utility: its eigenproblem can be spared.
  [[nodiscard]] virtual bool may_cut(const SubgraphStore& store, const Subgraph& graph) const = 0;
  // Told of every eigendecomposition before cuts of `graph` and its parts are asked for; row i of
  // `vectors` belongs to store.vertices(graph)[i], column k is order k of the store.
  virtual void decomposed(const SubgraphStore& /*store*/, const Subgraph& /*graph*/,
                          const Eigen::Ref<const Eigen::MatrixXd>& /*vectors*/) {}
  // The best cut of a part along the orders of the store.
  [[nodiscard]] virtual Cut find(const SubgraphStore& store, const Subgraph& graph) = 0;
};

}  // namespace cleave::segmentation
