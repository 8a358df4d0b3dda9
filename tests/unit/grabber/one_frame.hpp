// SPDX-License-Identifier: BSD-3-Clause
// A source of one frame, for what stands between a source and the grabber.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "sensor/sources/source.hpp"

namespace cleave::sensor::test {

// One frame of points (i, 0, 1).
class OneFrame : public Source {
 public:
  OneFrame(std::uint32_t width, std::uint32_t height,
           const Intrinsics& intrinsics = {100, 100, 1.5F, .5F})
      : width_(width), height_(height), intrinsics_(intrinsics) {}

  [[nodiscard]] Failure open() override { return std::nullopt; }
  [[nodiscard]] Poll next(std::chrono::milliseconds /*timeout*/, Frame& frame) override {
    if (std::exchange(given_, true)) return Poll::end;
    frame = {width_, height_, intrinsics_, 7, 9, true};
    return Poll::frame;
  }
  void write_points(float* xyz) override {
    for (std::uint32_t i = 0; i < width_ * height_; ++i, xyz += 3) {
      std::copy_n(std::array{static_cast<float>(i), 0.0F, 1.0F}.data(), 3, xyz);
    }
  }
  [[nodiscard]] bool realtime() const override { return false; }
  [[nodiscard]] SourceCounts counts() const override { return {3, {}}; }
  [[nodiscard]] std::string last_error() const override { return "none"; }

 private:
  std::uint32_t width_, height_;
  Intrinsics intrinsics_;
  bool given_ = false;
};

}  // namespace cleave::sensor::test
