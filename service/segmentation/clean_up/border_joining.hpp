// SPDX-License-Identifier: BSD-3-Clause
// What a cut in two cannot see: whether a border as a whole gives a reason to part its segments.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/graph/surfel.hpp"
#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/math/union_find.hpp"
#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Evidence is pooled over all edges of the border of two segments, each counting by the length of
// its border, and two segments join if
// - the border has links and is not worth a cut itself: a cut elsewhere has parted them;
// - it is convex over some length, whatever equation 4.6 says of its edges: that two surfaces
//   touch in a point by chance happens in a point; or
// - both are hollow, and the border bends no more than a hollow surface does. Where a bowl or a mug
//   bends by more than the cannot-link angle from one supervoxel to the next, it was cut into
//   strips; of two bodies that touch, neither is hollow.
// All borders are judged at once, as they are before. Deterministic; no allocation once warm.
class BorderJoiner {
 public:
  // `segment`, of a supervoxel, is changed in place: the lowest number of those that join stays,
  // others are not used any more.
  void join(const std::vector<SupervoxelEdge>& edges, const std::vector<Surfel>& supervoxels,
            const GraphOptions& graph, std::uint32_t segments, std::vector<std::uint32_t>& segment);

 private:
  // Sums over edges. Curvature is bend over square: of a ball of radius r, 1/r; negative inside.
  struct Curvature {
    double bend = 0, square = 0;
    [[nodiscard]] bool known() const { return square > 0; }
    [[nodiscard]] double per_metre() const { return bend / square; }
  };
  struct Border {
    double length = 0, convex = 0, linking = 0;  // touching voxels
    double weight = 0, cannot_links = 0;         // of valid edges
    double step_m = 0;                           // times length, at 1 m distance
    double curvature = 0, curved_length = 0;     // of valid edges
  };
  void pool(const std::vector<SupervoxelEdge>& edges, const std::vector<Surfel>& supervoxels,
            std::uint32_t segments, const std::vector<std::uint32_t>& segment);
  [[nodiscard]] static bool is_worth_no_cut(const Border& border);
  [[nodiscard]] static bool is_convex(const Border& border, const GraphOptions& graph);
  [[nodiscard]] static bool is_hollow(const Border& border, const Curvature& a, const Curvature& b);

  CellRanking ranking_;
  std::vector<std::uint64_t> pair_;  // of an edge between segments
  std::vector<std::uint32_t> edge_;
  std::vector<Border> border_;
  std::vector<Curvature> inside_;  // a segment
  UnionFind joined_;               // segments
};

}  // namespace cleave::segmentation
