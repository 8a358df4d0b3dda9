// SPDX-License-Identifier: BSD-3-Clause
// How a cloud is looked at: from where, along which axes, in which order.
#pragma once

#include <Eigen/Core>

#include "segmentation/view/storage_order.hpp"

namespace cleave::segmentation {

struct View {
  StorageOrder order;  // other than the default only of images
  // Where the sensor is, relative to what the coordinates are relative to, and its axes (right,
  // down, forward) in the rows: axes * (point - centre) is the point as the sensor sees it. Used
  // only if `moved`: where a cloud is in its sensor's frame already, its coordinates stay as they
  // are to the last bit.
  bool moved = false;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  // Whether the sampling is even as seen from there; else it is in metres, or there are several
  // viewpoints.
  bool one_viewpoint = false;

  [[nodiscard]] bool changes_nothing() const { return order.upright() && !moved; }
};

}  // namespace cleave::segmentation
