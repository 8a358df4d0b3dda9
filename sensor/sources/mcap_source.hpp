// SPDX-License-Identifier: BSD-3-Clause
// The clouds of a recording, as if a camera had sent them again.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "recording/frames/gap_limit.hpp"
#include "recording/frames/read_ahead.hpp"
#include "recording/units/unit.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// Points come back bit for bit, with the capture and device times that were recorded. A recording
// of several sensors plays the one that its first cloud is of. A recording that is not ours plays
// one topic (recording::open_frames), with its messages' times. What is damaged, too large for the
// stream or of no use is named in the log, counted by cause, and passed over. Where the recording's
// clock jumps, the next frame is due after the longest gap at most, which is said once.
class McapSource : public Source {
 public:
  // `unit`: of the clouds, which are scaled to metres. Without one, open() refuses a recording
  // whose first cloud seems to be in millimetres.
  McapSource(const std::filesystem::path& path, bool loop, std::string topic = "",
             recording::GapLimit gaps = recording::GapLimit(),
             std::optional<recording::Unit> unit = {}, std::uint64_t max_points = capacity_points);

  [[nodiscard]] Failure open() override;
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return false; }
  [[nodiscard]] SourceCounts counts() const override;
  [[nodiscard]] std::string last_error() const override { return error_; }

 private:
  [[nodiscard]] recording::ReadAhead::Result read(std::chrono::milliseconds timeout,
                                                  recording::AheadFrame& ahead);
  void note_problems();
  void note_losses();
  [[nodiscard]] std::chrono::nanoseconds until_next();

  std::filesystem::path path_;
  std::string topic_;  // empty: the only one
  bool loop_;
  recording::GapLimit gaps_;
  std::optional<recording::Unit> unit_;
  std::uint64_t max_points_;
  std::string sensor_;
  std::unique_ptr<recording::ReadAhead> reader_;
  std::optional<recording::AheadFrame> held_;  // write_points() writes its points
  std::optional<recording::AheadFrame> next_;  // the one after, for its time
  bool ended_ = false;
  bool said_jump_ = false;
  std::map<std::string, std::uint64_t> unusable_;  // beyond what reader_ counts
  std::string error_;
};

}  // namespace cleave::sensor
