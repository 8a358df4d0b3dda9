// SPDX-License-Identifier: BSD-3-Clause
// The camera of an OpenNI recording: from its frames to points.
#pragma once

#include <cstdint>

#include "recording/cloud/depth_to_points.hpp"
#include "recording/oni/oni_reader.hpp"

namespace cleave::oni {

// The grabber plays, and `cleave convert` reads, through this: both get the same points, bit for
// bit. Deterministic.
class Camera {
 public:
  // Throws std::runtime_error with the reason why no cloud can come out of the recording: it has no
  // frame, more pixels than `max_points`, or not the fields of view.
  explicit Camera(const Reader& reader, std::uint64_t max_points);

  // Of the images as recorded: where they are cropped, the principal point moves along. In pixels.
  [[nodiscard]] const recording::Intrinsics& intrinsics() const { return intrinsics_; }
  // Swaps left and right of a frame as it was read where the recording is mirrored, so that x is to
  // the right. Once a frame.
  void turn_back(DepthFrame& frame) const;
  // Writes width * height points of a frame that was turned back: metres, optical frame, row-major,
  // NaN NaN NaN = no measurement.
  void write_points(const DepthFrame& frame, float* xyz) const;

 private:
  DepthStream stream_;
  recording::Intrinsics intrinsics_;
  recording::DepthProjection projection_;
};

}  // namespace cleave::oni
