// SPDX-License-Identifier: BSD-3-Clause
// A few pixels of an organised cloud that tell what camera took it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/view/middle.hpp"

namespace cleave::segmentation {

struct SampledPixel {
  Eigen::Vector3d point;              // as in the cloud, metres
  double column = 0, row = 0;         // as stored
  std::uint32_t line = 0, level = 0;  // which of the sampled columns and rows it lies in
};

// Measured points in the columns and rows of an even lattice, of which there are `lines` each or as
// many as the image has; more where few of them are measured.
class PixelSample {
 public:
  static constexpr std::uint32_t max_lines = 128;

  void take(const CloudView& cloud);
  [[nodiscard]] const std::vector<SampledPixel>& pixels() const { return pixels_; }

  // For what follows, once a sample is taken.
  void find_middle();
  [[nodiscard]] const Eigen::Vector3d& middle() const { return middle_.place; }
  [[nodiscard]] double extent_m() const { return middle_.extent_m; }

 private:
  void take(const CloudView& cloud, std::uint32_t lines);

  std::vector<SampledPixel> pixels_;
  std::vector<Eigen::Vector3d> points_;  // of the pixels
  MiddleFinder middle_finder_;
  Middle middle_;
};

}  // namespace cleave::segmentation
