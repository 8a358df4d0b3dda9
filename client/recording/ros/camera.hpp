// SPDX-License-Identifier: BSD-3-Clause
// The camera of a depth image.
#pragma once

#include <cstdint>
#include <string>

#include "recording/cloud/projection.hpp"
#include "recording/ros/messages.hpp"

namespace cleave::recording::ros {

struct Camera {
  Intrinsics intrinsics;  // of the image's pixels
  std::string remark;     // what is left out of account; empty = nothing
};

// Which image of a camera it is: CameraInfo describes both.
enum class ImageKind {
  raw,       // K, with the lens's distortion
  rectified  // P
};

// By its topic's name, as image_proc and drivers write it: image_rect, image_rect_raw, ...
[[nodiscard]] ImageKind kind_of(const std::string& image_topic);

// The pinhole camera of an image of `width` x `height` pixels: K of a raw one, P of a rectified
// one, or the other where that is 0, moved by the region of interest and scaled by the binning, as
// image_geometry does. The distortion of a raw image is not taken back, which `remark` says.
// Throws Unusable where K and P are 0 (nobody calibrated it), or CameraInfo is of another size.
[[nodiscard]] Camera camera_of(const CameraInfo& info, ImageKind kind, std::uint32_t width,
                               std::uint32_t height);

}  // namespace cleave::recording::ros
