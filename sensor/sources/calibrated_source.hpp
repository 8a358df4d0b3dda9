// SPDX-License-Identifier: BSD-3-Clause
// Another source's images, seen through a camera that somebody has measured.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recording/cloud/depth_to_points.hpp"
#include "sensor/sources/source.hpp"

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
class CalibratedSource : public Source {
 public:
  CalibratedSource(std::unique_ptr<Source> source, const Calibration& calibration)
      : source_(std::move(source)), calibration_(calibration) {}

  [[nodiscard]] Failure open() override { return source_->open(); }
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return source_->realtime(); }
  [[nodiscard]] SourceCounts counts() const override { return source_->counts(); }
  [[nodiscard]] std::string last_error() const override { return source_->last_error(); }
  [[nodiscard]] bool in_use() const override { return source_->in_use(); }

 private:
  [[nodiscard]] bool redraws(const Frame& frame) const;

  std::unique_ptr<Source> source_;
  const Calibration calibration_;
  Frame frame_;  // that is held, as calibrated
  recording::DepthProjection projection_;
  std::uint32_t width_ = 0, height_ = 0;  // of the projection
  std::vector<float> depth_m_;
};

}  // namespace cleave::sensor
