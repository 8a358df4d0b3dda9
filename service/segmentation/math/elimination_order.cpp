// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/elimination_order.hpp"

#include <amd.h>

namespace cleave::segmentation {

void EliminationOrder::list_neighbours(std::span<const WeightedEdge> edges) {
  for (const WeightedEdge& edge : edges) {
    ++degree_[edge.first];
    ++degree_[edge.second];
  }
  int end = 0;
  for (std::size_t v = 0; v < degree_.size(); ++v) {
    begin_[v] = end;
    end += degree_[v];
    w_[v] = begin_[v];
  }
  for (const WeightedEdge& edge : edges) {
    neighbours_[static_cast<std::size_t>(w_[edge.first]++)] = static_cast<int>(edge.second);
    neighbours_[static_cast<std::size_t>(w_[edge.second]++)] = static_cast<int>(edge.first);
  }
}

std::span<const int> EliminationOrder::ranks(std::size_t vertices,
                                             std::span<const WeightedEdge> edges) {
  const std::size_t entries = 2 * edges.size();
  for (auto* array : {&begin_, &rank_, &vertex_at_, &nv_, &head_, &elen_, &degrees_, &w_}) {
    array->resize(vertices);
  }
  degree_.assign(vertices, 0);
  neighbours_.resize(entries + entries / 5 + vertices + 1);  // the elbow room that AMD asks for
  list_neighbours(edges);
  // The entry that takes its working memory, where amd_order() allocates.
  amd_2(static_cast<int>(vertices), begin_.data(), neighbours_.data(), degree_.data(),
        static_cast<int>(neighbours_.size()), static_cast<int>(entries), nv_.data(), rank_.data(),
        vertex_at_.data(), head_.data(), elen_.data(), degrees_.data(), w_.data(), nullptr,
        nullptr);
  return rank_;
}

}  // namespace cleave::segmentation
