// SPDX-License-Identifier: BSD-3-Clause
// A PCD file's points as the segmentation takes them.
#pragma once

#include <optional>
#include <span>

#include "recording/pcd/cloud.hpp"
#include "recording/units/unit.hpp"
#include "segmentation/cloud_view.hpp"

namespace cleave::workbench {

// With the pose that the file's VIEWPOINT says. Lives as long as `cloud`, in whose unit it is.
[[nodiscard]] inline segmentation::CloudView view_of(const recording::PcdCloud& cloud) {
  segmentation::CloudView view{.xyz = cloud.xyz().data(),
                               .stride = 3,
                               .width = cloud.header().width,
                               .height = cloud.header().height,
                               .origin_m = cloud.origin()};
  if (const auto pose = cloud.sensor_pose()) view.pose = {pose->position, pose->orientation};
  return view;
}

// The same cloud in metres: `xyz` are its points, scaled; the rest is scaled here.
[[nodiscard]] inline segmentation::CloudView view_in_metres(const recording::PcdCloud& cloud,
                                                            std::span<const float> xyz,
                                                            std::optional<recording::Unit> unit) {
  segmentation::CloudView view = view_of(cloud);
  view.xyz = xyz.data();
  const double divisor = units_a_metre(unit.value_or(recording::Unit::metre));
  for (double& coordinate : view.origin_m) coordinate /= divisor;
  if (view.pose) {
    for (double& coordinate : view.pose->position_m) coordinate /= divisor;
  }
  return view;
}

}  // namespace cleave::workbench
