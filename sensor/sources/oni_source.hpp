// SPDX-License-Identifier: BSD-3-Clause
// A recording by OpenNI (.oni), as if its camera were there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "libcleave/process/logging.hpp"
#include "recording/oni/camera.hpp"
#include "recording/oni/oni_reader.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// Every frame, in the order of the file; frames that are damaged are skipped, counted and logged.
// A mirrored recording is turned back: x is to the right. Device times are those of the recording.
class OniSource : public Source {
 public:
  // With `loop` it is played again and again.
  OniSource(const std::filesystem::path& file, bool loop,
            std::uint64_t max_points = capacity_points);

  // Fails where the file holds no frame of at most `max_points`, or not the fields of view.
  [[nodiscard]] Failure open() override;
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return false; }
  [[nodiscard]] SourceCounts counts() const override;
  [[nodiscard]] std::string last_error() const override { return ""; }

 private:
  // The next frame that is not damaged; false at the end of the file.
  [[nodiscard]] bool read_next();

  std::filesystem::path path_;
  bool loop_;
  std::uint64_t max_points_;
  std::optional<oni::Reader> reader_;
  std::optional<oni::Camera> camera_;
  std::size_t next_ = 0;
  oni::DepthFrame held_;
  std::uint64_t damaged_ = 0;
  LogLimiter log_limiter_;
};

}  // namespace cleave::sensor
