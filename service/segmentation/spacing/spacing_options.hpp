// SPDX-License-Identifier: BSD-3-Clause
// Defaults that follow how dense a cloud is.
#pragma once

#include "segmentation/options.hpp"
#include "segmentation/spacing/cloud_spacing.hpp"

namespace cleave::segmentation {

// The options with, unless voxel.follow_spacing is off,
// - supervoxel.seed_spacing_m grown as voxels have, and no less than 2.5 cells, if it has its
//   default: a patch of fewer has no normal of its own. In an image that is so beyond 1.7 m;
// - clean_up.min_segment_points, if it has its default, no more than the points of 18 cells or
//   voxels, but 36 at least, and at most a 50th of all points. In an image of 640 x 480 pixels
//   cells hold 9 and the default stays; what is small there is an object in an image of 160 x 120
//   or in a cloud that a filter has thinned, and all of a cloud of a hundred points;
// - clean_up.weak_border_points in proportion, if it has its default as well.
[[nodiscard]] Options options_for_spacing(const Options& options, const CloudSpacing& spacing);

}  // namespace cleave::segmentation
