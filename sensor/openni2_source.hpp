// A depth camera through OpenNI2, or the synthetic one that is an OpenNI2 driver of ours.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sensor/source.hpp"

namespace cleave::sensor {

struct VideoMode {
  std::uint32_t width = 640;   // pixels
  std::uint32_t height = 480;  // pixels
  std::uint32_t fps = 30;
};

// All calls from one thread, as OpenNI2 wants it. A camera is lost when it is unplugged, when it
// reports an error, or when it sends nothing for 1.5 s (or three frames, if that is longer).
class OpenNi2Source : public Source {
 public:
  // `uri` as OpenNI2 lists it; empty = the first camera.
  OpenNi2Source(std::string uri, const VideoMode& mode);
  ~OpenNi2Source() override;

  [[nodiscard]] Failure open() override;
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return true; }
  [[nodiscard]] SourceCounts counts() const override;
  [[nodiscard]] std::string last_error() const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cleave::sensor
