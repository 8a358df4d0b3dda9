// SPDX-License-Identifier: BSD-3-Clause
// The supervised mode of section 5.3.2: cuts that agree with the truth.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/partition/best_cut.hpp"
#include "segmentation/partition/cut_finder.hpp"

namespace cleave::segmentation {

struct GuidedCut {
  std::uint32_t eigenvector = 0;  // that the cut is along; 1 is the smallest after the trivial one
  double utility = 0;             // equation 4.8
};

// Takes the first eigenvector whose best cut (Algorithm 2) agrees with the truth, whatever its
// utility, and remembers which that was. An object counts in the part that holds at least half of
// its points. A cut agrees if it leaves 95 % of every such object on one side, and an object on
// either.
class GuidedCutFinder final : public CutFinder {
 public:
  // `object` (0 = none) and `points` of a vertex; both must outlive the cuts.
  void start(std::span<const std::uint32_t> object, std::span<const std::uint32_t> points);

  [[nodiscard]] bool may_cut(const SubgraphStore& store, const Subgraph& graph) const override;
  [[nodiscard]] Cut find(const SubgraphStore& store, const Subgraph& graph) override;

  // Since start(), in the order in which they were made.
  [[nodiscard]] const std::vector<GuidedCut>& cuts() const { return cuts_; }

 private:
  [[nodiscard]] bool agrees(std::span<const std::uint32_t> side,
                            std::span<const std::uint32_t> others) const;
  void count(std::span<const std::uint32_t> vertices, std::vector<double>& points) const;

  BestCutFinder best_cut_finder_;
  std::span<const std::uint32_t> object_, points_;
  std::vector<double> points_of_object_;
  std::vector<GuidedCut> cuts_;
};

}  // namespace cleave::segmentation
