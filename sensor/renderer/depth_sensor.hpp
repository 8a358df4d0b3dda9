// SPDX-License-Identifier: BSD-3-Clause
// What a structured-light camera makes of the hits of its rays: noise, quantisation, missing
// pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "sensor/renderer/labelled_depth.hpp"
#include "sensor/renderer/view/ray_cast.hpp"

namespace cleave::render {

// The camera measures disparities D in whole steps: z = 348 m / D, rounded to 1 mm.
inline constexpr double disparity_metres = 348;

// Everything that the frames from one pose share is computed once, by the constructor. The numbers
// were fitted to the planes of real table-top scenes: noise of 2.75 mm x z^2 (z in m) along the
// ray, quantisation included, 40 % of its variance of low frequency.
class DepthSensor {
 public:
  explicit DepthSensor(const RayCast& rays);

  // Deterministic: the same noise seed gives the same frame. Safe to call from several threads.
  [[nodiscard]] LabelledDepth measure(std::uint64_t noise_seed) const;
  // The depth of what is measurable, rounded to 1 mm and otherwise exact.
  [[nodiscard]] LabelledDepth measure_without_noise() const;

 private:
  struct Pixel {
    float depth_m;
    float disparity;   // mean of the 5 x 5 pixels that are on the same side of each depth edge
    float edge_share;  // of the 5 x 5 pixels that are not
    float cosine;
    std::uint16_t surface;
    std::uint16_t label;  // 0 = not measurable
  };

  std::uint32_t width_;
  std::uint32_t height_;
  std::vector<Pixel> pixels_;
};

}  // namespace cleave::render
