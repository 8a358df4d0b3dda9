// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/options.hpp"

#include <numbers>

namespace cleave::segmentation {

Options thesis() {
  constexpr float degree_rad = std::numbers::pi_v<float> / 180;
  Options options;
  options.representation = Representation::voxels;
  options.voxel.size_m = 0.0075F;
  options.voxel.follow_spacing = false;
  options.supervoxel.seed_spacing_m = 0.03F;
  options.supervoxel.normal_weight = 4;
  options.supervoxel.min_seed_voxels = 1;
  options.supervoxel.refit_from_points = false;
  options.graph.weight_sigma = 10;
  options.graph.validity_max_rad = 57 * degree_rad;
  options.graph.validity_offset_rad = 33 * degree_rad;
  options.graph.cannot_link_rad = 45 * degree_rad;
  options.graph.soft_cannot_link_rad = 45 * degree_rad;
  options.graph.max_step_m = 0;
  options.partition.eigenvectors = 10;
  options.partition.utility_threshold = 1;
  options.partition.coarsening_rounds = 0;
  options.clean_up.join_across_borders = false;
  options.clean_up.min_segment_points = 0;
  options.clean_up.weak_border_points = 0;
  options.refine.boundary = false;
  options.refine.mode_filter_radius = 0;
  return options;
}

}  // namespace cleave::segmentation
