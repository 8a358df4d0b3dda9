// SPDX-License-Identifier: BSD-3-Clause
// Another source's images with fewer points.
#pragma once

#include <memory>
#include <vector>

#include "recording/cloud/decimate.hpp"
#include "sensor/sources/wrapped_source.hpp"

namespace cleave::sensor {

// For cameras with more points than the contract carries, and for who wants less: a block of
// `factor` x `factor` pixels becomes one (see Decimator). A frame that is no image passes
// unchanged.
class DecimatingSource : public WrappedSource {
 public:
  // `factor` is 2 or more.
  DecimatingSource(std::unique_ptr<Source> source, std::uint32_t factor)
      : WrappedSource(std::move(source)), decimator_(factor) {}

  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;

 private:
  recording::Decimator decimator_;
  Frame whole_;             // as the source has it
  std::vector<float> xyz_;  // its points
};

}  // namespace cleave::sensor
