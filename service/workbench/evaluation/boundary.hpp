// SPDX-License-Identifier: BSD-3-Clause
// How well the borders between segments are found, in the image.
#pragma once

#include <cstdint>
#include <span>

#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::evaluation {

struct BoundaryScore {
  double precision = 0;  // share of the found border that lies near the true one
  double recall = 0;     // share of the true border that lies near the found one
  double f = 0;          // their harmonic mean
};

// 0.8 % of the image's diagonal (Perazzi et al., "A Benchmark Dataset and Evaluation Methodology
// for Video Object Segmentation", CVPR 2016), rounded, at least 1: 6 pixels for 640 x 480.
[[nodiscard]] std::uint32_t boundary_tolerance_px(std::uint32_t width, std::uint32_t height);

// Row-major images of `width` columns, one true and one found label a pixel. Pixels whose true
// label is 0 do not count and have no border. A pixel is on a border if its right or lower
// neighbour counts and has another label; "near" is within `tolerance_px`, Euclidean. Where neither
// image has a border all is 1; where one has none, all is 0.
[[nodiscard]] BoundaryScore judge_boundaries(std::uint32_t width,
                                             std::span<const std::uint32_t> truth,
                                             std::span<const std::uint16_t> found,
                                             std::uint32_t tolerance_px);

// The same for a labelled cloud, with the tolerance above. A cloud that is no image is projected
// onto one first (depth_image, filled_size), where the nearest point counts.
[[nodiscard]] BoundaryScore judge_boundaries(const LabelledCloud& cloud,
                                             std::span<const std::uint16_t> found);

}  // namespace cleave::evaluation
