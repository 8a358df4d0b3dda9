// SPDX-License-Identifier: BSD-3-Clause
// Another source's images with fewer points.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "recording/cloud/decimate.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// For cameras with more points than the contract carries, and for who wants less: a block of
// `factor` x `factor` pixels becomes one (see Decimator). A frame that is no image passes
// unchanged.
class DecimatingSource : public Source {
 public:
  // `factor` is 2 or more.
  DecimatingSource(std::unique_ptr<Source> source, std::uint32_t factor)
      : source_(std::move(source)), decimator_(factor) {}

  [[nodiscard]] Failure open() override { return source_->open(); }
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return source_->realtime(); }
  [[nodiscard]] SourceCounts counts() const override { return source_->counts(); }
  [[nodiscard]] std::string last_error() const override { return source_->last_error(); }
  [[nodiscard]] bool in_use() const override { return source_->in_use(); }

 private:
  std::unique_ptr<Source> source_;
  recording::Decimator decimator_;
  Frame whole_;             // as the source has it
  std::vector<float> xyz_;  // its points
};

}  // namespace cleave::sensor
