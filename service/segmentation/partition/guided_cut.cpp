// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/guided_cut.hpp"

#include <algorithm>

namespace cleave::segmentation {
namespace {

constexpr double least_share_to_count = 0.5;
constexpr double least_share_on_a_side = 0.95;

}  // namespace

void GuidedCutFinder::start(std::span<const std::uint32_t> object,
                            std::span<const std::uint32_t> points) {
  object_ = object;
  points_ = points;
  cuts_.clear();
  const std::uint32_t last = object.empty() ? 0 : *std::max_element(object.begin(), object.end());
  points_of_object_.assign(last + std::size_t{1}, 0);
  for (std::size_t v = 0; v < object.size(); ++v) points_of_object_[object[v]] += points[v];
}

void GuidedCutFinder::count(std::span<const std::uint32_t> vertices,
                            std::vector<double>& points) const {
  points.assign(points_of_object_.size(), 0);
  for (const std::uint32_t v : vertices) points[object_[v]] += points_[v];
}

bool GuidedCutFinder::may_cut(const SubgraphStore& store, const Subgraph& graph) const {
  return best_cut_finder_.may_cut(store, graph);
}

bool GuidedCutFinder::agrees(std::span<const std::uint32_t> side,
                             std::span<const std::uint32_t> others) const {
  std::vector<double> left, right;
  count(side, left);
  count(others, right);
  bool some_left = false;
  bool some_right = false;
  for (std::size_t object = 1; object < left.size(); ++object) {
    const double both = left[object] + right[object];
    if (both == 0 || both < least_share_to_count * points_of_object_[object]) continue;
    if (std::max(left[object], right[object]) < least_share_on_a_side * both) return false;
    (left[object] > right[object] ? some_left : some_right) = true;
  }
  return some_left && some_right;
}

Cut GuidedCutFinder::find(const SubgraphStore& store, const Subgraph& graph) {
  for (std::size_t k = 0; k < store.orders(); ++k) {
    const Cut cut = best_cut_finder_.find_along(k, store, graph);
    if (cut.utility == 0) continue;
    const auto order = store.order(k, graph);
    if (!agrees(order.first(cut.position), order.subspan(cut.position))) continue;
    cuts_.push_back({static_cast<std::uint32_t>(k + 1), cut.utility});
    return cut;
  }
  return {};
}

}  // namespace cleave::segmentation
