// The clouds of a recording, as if a camera had sent them again.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "recording/frames/read_ahead.hpp"
#include "recording/units/unit.hpp"
#include "sensor/source.hpp"

namespace cleave::sensor {

// Points come back bit for bit, with the capture and device times that were recorded. A recording
// of several sensors plays the one that its first cloud is of. Damage is named in the log, counted,
// and passed over.
class McapSource : public Source {
 public:
  // `unit`: of the clouds, which are scaled to metres. Without one, open() refuses a recording
  // whose first cloud seems to be in millimetres.
  McapSource(const std::filesystem::path& path, bool loop,
             std::optional<recording::Unit> unit = {});

  [[nodiscard]] Failure open() override;
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return false; }
  [[nodiscard]] SourceCounts counts() const override;
  [[nodiscard]] std::string last_error() const override { return error_; }

 private:
  void note_problems();

  std::filesystem::path path_;
  bool loop_;
  std::optional<recording::Unit> unit_;
  std::string sensor_;
  std::unique_ptr<recording::ReadAhead> reader_;
  std::optional<recording::AheadFrame> held_;  // write_points() writes its points
  std::optional<recording::AheadFrame> next_;  // the one after, for its time
  bool ended_ = false;
  std::uint64_t damaged_ = 0;
  std::string error_;
};

}  // namespace cleave::sensor
