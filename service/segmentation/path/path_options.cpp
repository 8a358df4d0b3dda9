// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/path/path_options.hpp"

#include "segmentation/spacing/spacing_options.hpp"

namespace cleave::segmentation {

bool images_become_cells(const Options& options) {
  return options.representation == Representation::cells && options.algorithm != Algorithm::svc &&
         options.voxel.viewpoint != Viewpoint::multiple;
}

Options options_on(const SupervoxelPath& path, const Options& options) {
  Options result = options_for_spacing(options, path.spacing());
  if (!path.seen_from_one_viewpoint()) result.graph.max_step_m = 0;
  return result;
}

}  // namespace cleave::segmentation
