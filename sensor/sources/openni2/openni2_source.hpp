// SPDX-License-Identifier: BSD-3-Clause
// A depth camera through OpenNI2, or the synthetic one that is an OpenNI2 driver of ours.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// What a camera is asked for; what it lacks is refused.
struct VideoMode {
  std::uint32_t width = 640;   // pixels
  std::uint32_t height = 480;  // pixels
  std::uint32_t fps = 30;
  bool registration = false;  // depth as seen by the camera's colour sensor
  bool mirror = false;        // left and right swapped
};

// All calls from one thread, as OpenNI2 wants it. A camera is lost when it is unplugged, when it
// reports an error, or when it sends nothing for 0.8 s (or three frames, if that is longer). Its
// first frame may take 5 s.
class OpenNi2Source : public Source {
 public:
  // `uri` as OpenNI2 lists it; "serial=TEXT" = the camera with this serial number, wherever it is
  // plugged in; empty = the first camera.
  OpenNi2Source(std::string uri, const VideoMode& mode);
  ~OpenNi2Source() override;

  [[nodiscard]] Failure open() override;
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return true; }
  [[nodiscard]] SourceCounts counts() const override;
  [[nodiscard]] std::string last_error() const override;
  [[nodiscard]] bool in_use() const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cleave::sensor
