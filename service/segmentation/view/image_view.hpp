// SPDX-License-Identifier: BSD-3-Clause
// Finds how an organised cloud has to be looked at to be an upright image from one viewpoint.
#pragma once

#include <optional>

#include "segmentation/cloud_view.hpp"
#include "segmentation/view/camera/camera_finder.hpp"
#include "segmentation/view/camera/pixel_sample.hpp"
#include "segmentation/view/own_frame.hpp"
#include "segmentation/view/view.hpp"

namespace cleave::segmentation {

// The same image in any of the eight storage orders, and in any frame, gets the same view; a cloud
// in its sensor's frame stays there.
class ImageViewFinder {
 public:
  // Nothing for an unorganised cloud, and where the cloud is no image of a pinhole camera. An image
  // that only roughly is one, for instance for its lens, is found in its sensor's frame only.
  [[nodiscard]] std::optional<View> find(const CloudView& cloud);

 private:
  PixelSample sample_;
  OwnFrameFinder own_frame_;
  CameraFinder camera_;
};

}  // namespace cleave::segmentation
