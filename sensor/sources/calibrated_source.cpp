// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/calibrated_source.hpp"

#include <cstddef>

namespace cleave::sensor {

// An image, and there are rays to draw.
bool CalibratedSource::redraws(const Frame& frame) const {
  return calibration_.intrinsics != Intrinsics{} && frame.intrinsics != Intrinsics{};
}

Poll CalibratedSource::next(std::chrono::milliseconds timeout, Frame& frame) {
  const Poll poll = source().next(timeout, frame);
  if (poll != Poll::frame) return poll;
  if (redraws(frame)) frame.intrinsics = calibration_.intrinsics;
  frame_ = frame;
  return poll;
}

void CalibratedSource::write_points(float* xyz) {
  source().write_points(xyz);
  const std::size_t points = std::size_t{frame_.width} * frame_.height;
  if (!redraws(frame_)) {
    for (std::size_t i = 0; i < 3 * points; ++i) xyz[i] *= calibration_.depth_scale;
    return;
  }
  if (frame_.width != width_ || frame_.height != height_) {
    width_ = frame_.width;
    height_ = frame_.height;
    projection_ = {width_, height_, calibration_.intrinsics};
  }
  depth_m_.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    depth_m_[i] = xyz[3 * i + 2] * calibration_.depth_scale;
  }
  projection_.write_points(depth_m_, xyz);
}

}  // namespace cleave::sensor
