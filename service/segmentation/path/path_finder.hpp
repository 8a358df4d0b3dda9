// SPDX-License-Identifier: BSD-3-Clause
// Which way a cloud goes.
#pragma once

#include "segmentation/cells/cell_path.hpp"
#include "segmentation/cloud_view.hpp"
#include "segmentation/options.hpp"
#include "segmentation/view/seen_cloud.hpp"
#include "segmentation/voxels/svc_path.hpp"
#include "segmentation/voxels/voxel_path.hpp"

namespace cleave::segmentation {

// Reuses the memory of every path that it has taken.
class PathFinder {
 public:
  // Looks at the cloud and gathers its points: into cells where these are asked for and it is an
  // image from one viewpoint, else into voxels. Null if no point was measured. Until the next call.
  [[nodiscard]] SupervoxelPath* gather(const CloudView& cloud, const Options& options);
  // The cloud as seen, whose points the path has.
  [[nodiscard]] const SeenCloud& seen() const { return seen_; }
  [[nodiscard]] SeenCloud& seen() { return seen_; }

 private:
  SeenCloud seen_;
  CellPath cell_path_;
  VoxelPath voxel_path_;
  SvcPath svc_path_;
};

}  // namespace cleave::segmentation
