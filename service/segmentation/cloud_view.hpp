// SPDX-License-Identifier: BSD-3-Clause
// The input of everything here: someone else's points, looked at in place.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace cleave::segmentation {

// Where a sensor stood, in the frame of its cloud: a unit quaternion (w, x, y, z) turns the
// sensor's axes into the cloud's.
struct SensorPose {
  std::array<double, 3> position_m = {0, 0, 0};
  std::array<double, 4> orientation = {1, 0, 0, 0};
};

// Points as 3 floats each, `stride` floats apart, in any frame; metres. height = 1: unorganised,
// else an image stored row by row or in any other order: see view/image_view. What is_measured
// (view/measured) refuses gets label 0. The memory must outlive the call it is given to.
struct CloudView {
  const float* xyz = nullptr;
  std::size_t stride = 3;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  // What the coordinates are relative to: a float has no millimetres at a thousand kilometres.
  std::array<double, 3> origin_m = {0, 0, 0};
  // If it is known; in true coordinates, origin_m included. Its position counts where the points
  // do not say otherwise, its orientation where its z axis looks at them.
  std::optional<SensorPose> pose = std::nullopt;

  [[nodiscard]] std::size_t size() const { return std::size_t{width} * height; }
  [[nodiscard]] bool organised() const { return height > 1; }
  [[nodiscard]] const float* point(std::size_t i) const { return xyz + i * stride; }
};

}  // namespace cleave::segmentation
