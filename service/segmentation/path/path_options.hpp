// SPDX-License-Identifier: BSD-3-Clause
// What the options mean for a frame, and what a frame makes of the options.
#pragma once

#include "segmentation/options.hpp"
#include "segmentation/path/supervoxel_path.hpp"

namespace cleave::segmentation {

// Whether a cloud that is an image is made into cells. Any other is made into voxels.
[[nodiscard]] bool images_become_cells(const Options& options);

// Scaled to the spacing of the path's points (options_for_spacing); and without max_step_m where
// the points have no common viewpoint: what a step in depth means is known for a sensor in the
// origin.
[[nodiscard]] Options options_on(const SupervoxelPath& path, const Options& options);

}  // namespace cleave::segmentation
