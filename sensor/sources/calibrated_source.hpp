// SPDX-License-Identifier: BSD-3-Clause
// Another source's images, seen through a camera that somebody has measured.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "recording/cloud/depth_to_points.hpp"
#include "sensor/sources/wrapped_source.hpp"

namespace cleave::sensor {

struct Calibration {
  Intrinsics intrinsics;  // of the source's images; all 0 = the source's own
  float depth_scale = 1;  // what a depth of the source is multiplied by

  [[nodiscard]] bool changes_nothing() const {
    return intrinsics == Intrinsics{} && depth_scale == 1;
  }
};

// What drivers report of a camera is rough: focal lengths from nominal angles of view, a depth that
// is a percent too long. Of an image the depths are kept, scaled, and each pixel's ray is drawn
// anew; a frame that is no image is scaled only.
class CalibratedSource : public WrappedSource {
 public:
  CalibratedSource(std::unique_ptr<Source> source, const Calibration& calibration)
      : WrappedSource(std::move(source)), calibration_(calibration) {}

  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;

 private:
  [[nodiscard]] bool redraws(const Frame& frame) const;

  const Calibration calibration_;
  Frame frame_;  // that is held, as calibrated
  recording::DepthProjection projection_;
  std::uint32_t width_ = 0, height_ = 0;  // of the projection
  std::vector<float> depth_m_;
};

}  // namespace cleave::sensor
