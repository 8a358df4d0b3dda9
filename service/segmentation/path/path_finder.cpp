// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/path/path_finder.hpp"

#include "segmentation/path/path_options.hpp"

namespace cleave::segmentation {

SupervoxelPath* PathFinder::gather(const CloudView& cloud, const Options& options) {
  const bool svc = options.algorithm == Algorithm::svc;
  const bool wants_cells = images_become_cells(options);
  const bool is_image =
      options.voxel.viewpoint != Viewpoint::multiple && seen_.look_at_image(cloud);
  if (wants_cells && is_image && cell_path_.gather(seen_.cloud(), options.voxel)) {
    return &cell_path_;
  }
  if (!is_image || wants_cells) seen_.look_at_points(cloud, options.voxel.viewpoint);
  VoxelOptions voxel = options.voxel;
  voxel.viewpoint = seen_.from_one_viewpoint() ? Viewpoint::single : Viewpoint::multiple;
  VoxelPath& path = svc ? svc_path_ : voxel_path_;
  return path.gather(seen_.cloud(), voxel) ? &path : nullptr;
}

}  // namespace cleave::segmentation
