// SPDX-License-Identifier: BSD-3-Clause
// The first step of the segmentation, and its inverse: a cloud in the sensor's frame, images
// upright, and the results in the cloud's own frame and order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/options.hpp"
#include "segmentation/segmentation.hpp"
#include "segmentation/view/image_view.hpp"
#include "segmentation/view/point_view.hpp"
#include "segmentation/view/view.hpp"

namespace cleave::segmentation {

class SeenCloud {
 public:
  // True if the cloud is, or at least may be, an image from one viewpoint.
  [[nodiscard]] bool look_at_image(const CloudView& cloud);
  void look_at_points(const CloudView& cloud, Viewpoint viewpoint);

  // As seen: the cloud itself where nothing has to change. Lives until the next look.
  [[nodiscard]] const CloudView& cloud() const { return seen_; }
  [[nodiscard]] bool from_one_viewpoint() const { return view_.one_viewpoint; }
  // Where a point of cloud() is in the cloud that was looked at.
  [[nodiscard]] std::size_t stored_index(std::size_t seen) const;

  // Room for the labels of cloud(): `own` where the order is the same.
  [[nodiscard]] std::span<std::uint16_t> labels(std::span<std::uint16_t> own);
  // Hands labels and segments back in the order and frame of the cloud that was looked at.
  void give_back(std::span<std::uint16_t> own, Segmentation& result) const;

 private:
  void take(const CloudView& cloud, const View& view);

  ImageViewFinder image_finder_;
  PointViewFinder point_finder_;
  View view_;
  UprightImage upright_{{}, 0, 0};
  CloudView seen_;
  std::vector<float> xyz_;
  std::vector<std::uint16_t> labels_;
};

}  // namespace cleave::segmentation
