// SPDX-License-Identifier: BSD-3-Clause
// The segmentation's clouds as pictures take them.
#pragma once

#include "console/picture/depth_image.hpp"
#include "segmentation/cloud_view.hpp"

namespace cleave::workbench {

[[nodiscard]] inline PointsView points_of(const segmentation::CloudView& cloud) {
  return {cloud.xyz, cloud.stride, cloud.width, cloud.height};
}

}  // namespace cleave::workbench
