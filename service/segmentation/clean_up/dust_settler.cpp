// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/dust_settler.hpp"

#include <algorithm>
#include <numeric>

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {

// Segments without a point are left out: they are not there to be joined.
void DustSettler::list_contacts(const std::vector<SupervoxelEdge>& edges,
                                const std::vector<std::uint32_t>& segment_of_supervoxel) {
  contacts_.clear();
  for (SupervoxelEdge edge : edges) {
    edge.first = segment_of_supervoxel[edge.first];
    edge.second = segment_of_supervoxel[edge.second];
    if (edge.first == edge.second || points_[edge.first] == 0 || points_[edge.second] == 0)
      continue;
    contacts_.push_back(edge);
  }
}

void DustSettler::drop_islands(std::uint32_t min_segment_points,
                               std::vector<std::uint32_t>& settled) {
  points_in_.assign(settled.size(), 0);
  for (std::size_t s = 0; s < settled.size(); ++s) points_in_[settled[s]] += points_[s];
  for (std::uint32_t& segment : settled) {
    if (points_in_[segment] < min_segment_points) segment = no_index;
  }
}

void DustSettler::settle(std::span<const PointRun> runs, const std::vector<SupervoxelEdge>& edges,
                         const std::vector<std::uint32_t>& segment_of_supervoxel,
                         std::uint32_t segments, std::uint32_t min_segment_points,
                         std::vector<std::uint32_t>& settled) {
  settled.resize(segments);
  std::iota(settled.begin(), settled.end(), 0U);
  points_.assign(segments, 0);
  for (const PointRun& run : runs) points_[run.segment] += run.end - run.begin;
  const bool any = std::ranges::any_of(
      points_, [&](std::uint32_t points) { return points > 0 && points < min_segment_points; });
  if (!any) return;

  list_contacts(edges, segment_of_supervoxel);
  const CleanUpOptions options{.join_across_borders = false,
                               .min_segment_points = min_segment_points,
                               .weak_border_points = 0};
  merger_.merge(contacts_, points_, segments, options, settled);
  drop_islands(min_segment_points, settled);
}

}  // namespace cleave::segmentation
