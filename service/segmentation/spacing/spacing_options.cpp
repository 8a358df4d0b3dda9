// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/spacing/spacing_options.hpp"

#include <algorithm>
#include <cstdint>

namespace cleave::segmentation {
namespace {

constexpr double cells_a_segment = 18;
constexpr double least_shape = 36;  // points that tell a thing from noise
constexpr double segments_a_cloud = 50;
constexpr double cells_a_seed = 2.5;

double least_points(const CloudSpacing& spacing) {
  const double most = CleanUpOptions{}.min_segment_points;
  const double least = std::clamp(cells_a_segment * spacing.points_a_cell, least_shape, most);
  return std::min(least, static_cast<double>(spacing.points) / segments_a_cloud);
}

}  // namespace

Options options_for_spacing(const Options& options, const CloudSpacing& spacing) {
  Options spaced = options;
  if (!options.voxel.follow_spacing) return spaced;
  const SupervoxelOptions default_supervoxel;
  const CleanUpOptions default_clean_up;
  if (spaced.supervoxel.seed_spacing_m == default_supervoxel.seed_spacing_m) {
    spaced.supervoxel.seed_spacing_m = std::max(default_supervoxel.seed_spacing_m * spacing.growth,
                                                static_cast<float>(cells_a_seed * spacing.cell_m));
  }
  CleanUpOptions& clean_up = spaced.clean_up;
  if (clean_up.min_segment_points == default_clean_up.min_segment_points) {
    const double least = least_points(spacing);
    clean_up.min_segment_points = static_cast<std::uint32_t>(least);
    if (clean_up.weak_border_points == default_clean_up.weak_border_points) {
      clean_up.weak_border_points = static_cast<std::uint32_t>(
          least / default_clean_up.min_segment_points * default_clean_up.weak_border_points);
    }
  }
  return spaced;
}

}  // namespace cleave::segmentation
