// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/segmenter.hpp"

namespace cleave::segmentation {

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::voxelise:
      return "voxelise";
    case Stage::normals:
      return "normals";
    case Stage::supervoxels:
      return "supervoxels";
    case Stage::graph:
      return "graph";
    case Stage::partition:
      return "partition";
    case Stage::clean_up:
      return "clean_up";
    case Stage::label_points:
      return "label_points";
    case Stage::describe:
      return "describe";
  }
  return "unknown";
}

}  // namespace cleave::segmentation
