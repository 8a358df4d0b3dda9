// A PCD file's points as the segmentation takes them.
#pragma once

#include "recording/pcd/cloud.hpp"
#include "segmentation/cloud_view.hpp"

namespace cleave::client {

// Relative to cloud.origin(); lives as long as `cloud`.
[[nodiscard]] inline segmentation::CloudView view_of(const recording::PcdCloud& cloud) {
  return {.xyz = cloud.xyz().data(),
          .stride = 3,
          .width = cloud.header().width,
          .height = cloud.header().height};
}

}  // namespace cleave::client
