// SPDX-License-Identifier: BSD-3-Clause
// Fewer points of an image: one for each block of pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "recording/cloud/projection.hpp"

namespace cleave::recording {

// Makes a block of `factor` x `factor` pixels into one. Its depth is the (lower) median of the
// valid ones, so that no depth comes about that nobody measured and an edge is not smeared; it is
// NaN NaN NaN where nothing was measured. With intrinsics the point lies on the ray through the
// block's middle, so that the result is a pinhole image again; without, it is the measured point.
// Columns and rows that fill no whole block are left out. Deterministic; one thread at a time.
class Decimator {
 public:
  // `factor` is 2 or more.
  explicit Decimator(std::uint32_t factor) : factor_(factor) {}

  [[nodiscard]] std::uint32_t width(std::uint32_t width) const { return width / factor_; }
  [[nodiscard]] std::uint32_t height(std::uint32_t height) const { return height / factor_; }
  // Of the smaller image; pixel centres are whole numbers in both. All 0 stays all 0.
  [[nodiscard]] Intrinsics intrinsics(const Intrinsics& of_image) const;

  // From width * height points, row-major, metres, optical frame, to as many as the sizes above
  // give.
  void decimate(const float* xyz, std::uint32_t width, std::uint32_t height,
                const Intrinsics& of_image, float* smaller);

 private:
  struct Candidate {
    float z;
    const float* point;
  };
  const Candidate* median(const float* xyz, std::uint32_t stride);

  std::uint32_t factor_;
  std::vector<Candidate> valid_;  // of a block
};

}  // namespace cleave::recording
