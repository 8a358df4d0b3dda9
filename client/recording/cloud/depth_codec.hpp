// SPDX-License-Identifier: BSD-3-Clause
// A cloud as a depth image, wherever that gives the points back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "recording/cloud/projection.hpp"
#include "recording/frames/frame.hpp"

namespace cleave::recording {

struct DepthImage {
  std::vector<std::uint16_t> depth_mm;  // row-major; 0 = no measurement
  Intrinsics intrinsics;
  Projection projection = Projection::none;
  // Added to the bits of x of all points, then of y, then of z, as signed bytes; empty = all 0.
  std::vector<std::uint8_t> correction;
};

// Finds the projection that explains a sensor's clouds, and tries that one first for the next
// cloud. One thread at a time; what is decoded does not depend on the clouds before.
class DepthEncoder {
 public:
  // The image, from which decode() gives back every coordinate bit for bit. Empty where depth alone
  // is further than 1e-6 m from any coordinate: no intrinsics, an unorganised cloud, depth off the
  // millimetre grid or not from 1 to 65,535 mm, a point of which only a part is finite.
  [[nodiscard]] std::optional<DepthImage> encode(const Cloud& cloud);

 private:
  struct Candidate {
    Intrinsics intrinsics;
    Projection projection;
  };
  [[nodiscard]] std::vector<Candidate> candidates(const FrameHeader& header) const;

  std::optional<Candidate> last_;
  std::vector<float> points_;  // kept for their memory
  std::vector<std::uint8_t> correction_;
};

// Writes 3 floats a pixel. Throws DataError where the parts of the image disagree in size, or the
// projection is not known.
void decode(const DepthImage& image, std::uint32_t width, std::uint32_t height, float* xyz);

}  // namespace cleave::recording
