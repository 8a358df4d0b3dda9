// The input of everything here: someone else's points, looked at in place.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cleave::segmentation {

// Points as 3 floats each, `stride` floats apart, row-major; optical frame of the sensor, metres.
// A point with a coordinate that is not finite is no measurement and gets label 0.
// height = 1: unorganised. The memory must outlive the call it is given to.
struct CloudView {
  const float* xyz = nullptr;
  std::size_t stride = 3;
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  [[nodiscard]] std::size_t size() const { return std::size_t{width} * height; }
  [[nodiscard]] bool organised() const { return height > 1; }
  [[nodiscard]] const float* point(std::size_t i) const { return xyz + i * stride; }
};

}  // namespace cleave::segmentation
