// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/describe/segment_borders.hpp"

#include <algorithm>

namespace cleave::segmentation {

void BorderDescriber::describe(const std::vector<SupervoxelEdge>& edges,
                               const std::vector<std::uint32_t>& segment_of_supervoxel,
                               const std::vector<std::uint16_t>& label_of_segment,
                               std::vector<Border>& borders) {
  between_segments_.clear();
  labels_.clear();
  for (const SupervoxelEdge& edge : edges) {
    const auto [low, high] = std::minmax(label_of_segment[segment_of_supervoxel[edge.first]],
                                         label_of_segment[segment_of_supervoxel[edge.second]]);
    // Label 0: the refinement has left the segment no point, or too few.
    if (low == high || low == 0) continue;
    between_segments_.push_back(&edge);
    labels_.push_back((std::uint64_t{low} << 16) | high);
  }
  ranking_.rank(labels_);

  const auto& pairs = ranking_.distinct_keys();
  lengths_.assign(pairs.size(), Length{});
  for (std::size_t i = 0; i < between_segments_.size(); ++i) {
    Length& length = lengths_[ranking_.rank_of_item()[i]];
    const SupervoxelEdge& edge = *between_segments_[i];
    std::uint64_t& sum = edge.valid
                             ? (edge.convex ? length.convex : length.concave)
                             : (edge.convex ? length.invalid_convex : length.invalid_concave);
    sum += edge.touching_voxels;
  }

  borders.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    borders.push_back({.first = static_cast<std::uint16_t>(pairs[p] >> 16),
                       .second = static_cast<std::uint16_t>(pairs[p] & 0xFFFF),
                       .kind = lengths_[p].is_convex() ? BorderKind::convex : BorderKind::concave});
  }
}

}  // namespace cleave::segmentation
