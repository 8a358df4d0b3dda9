// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/warm_segmenter.hpp"

#include <algorithm>
#include <memory>

#include "idl/capacity.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::service {
namespace {

constexpr std::uint32_t width = capacity_columns;
constexpr std::uint32_t height = capacity_rows;

// A floor 0.5 m below the camera that meets a wall 1.2 m before it: a depth camera's view with a
// concave crease.
std::vector<float> floor_and_wall() {
  constexpr float focal_px = 525;
  constexpr float floor_y_m = 0.5F;
  constexpr float wall_z_m = 1.2F;
  std::vector<float> xyz;
  xyz.reserve(std::size_t{width} * height * 3);
  for (std::uint32_t v = 0; v < height; ++v) {
    const float y = (static_cast<float>(v) - 0.5F * static_cast<float>(height)) / focal_px;
    const float z_m = y * wall_z_m > floor_y_m ? floor_y_m / y : wall_z_m;
    for (std::uint32_t u = 0; u < width; ++u) {
      const float x = (static_cast<float>(u) - 0.5F * static_cast<float>(width)) / focal_px;
      xyz.insert(xyz.end(), {x * z_m, y * z_m, z_m});
    }
  }
  return xyz;
}

}  // namespace

std::vector<SegmentFunction> warm_segmenters(const segmentation::Options& options,
                                             std::size_t count) {
  const std::vector<float> xyz = floor_and_wall();
  const segmentation::CloudView cloud{xyz.data(), 3, width, height};
  std::vector<std::uint16_t> labels(cloud.size());
  std::vector<SegmentFunction> segmenters;
  for (std::size_t i = 0; i < count; ++i) {
    const auto segmenter = std::make_shared<segmentation::Segmenter>(options);
    segmentation::Segmentation unused;
    (void)segmenter->segment(cloud, labels, unused);
    segmenters.emplace_back([segmenter](const segmentation::CloudView& view,
                                        std::span<std::uint16_t> out,
                                        segmentation::Segmentation& result) {
      return segmenter->segment(view, out, result);
    });
  }
  return segmenters;
}

}  // namespace cleave::service
