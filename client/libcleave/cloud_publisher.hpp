// SPDX-License-Identifier: BSD-3-Clause
// Your own camera on the stream: name, size, intrinsics and pose once, then a frame a call.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "libcleave/cloud_writer.hpp"
#include "libcleave/stream.hpp"

namespace cleave {

// What is the same in every frame of a sensor.
struct CloudSettings {
  std::string sensor = "camera";         // names the topics
  std::uint32_t width = 640;             // points a row
  std::uint32_t height = 480;            // rows; 1 = unorganised
  float fx = 0, fy = 0, cx = 0, cy = 0;  // pinhole intrinsics in pixels; all 0 = not an image
  std::string coordinate_frame;          // of the points; empty = "<sensor>_optical"
  // Where the sensor is: p_parent = orientation * p + position. Empty = not known.
  std::string parent_frame;
  std::array<float, 3> position{};     // x, y, z in metres
  std::array<float, 4> orientation{};  // quaternion x, y, z, w of unit length
};

// The sensor's only publisher on this machine; for all others it is its grabber, and as one it
// publishes its status. From one thread.
class CloudPublisher {
 public:
  // `stream` outlives this. Throws std::runtime_error: another process publishes this sensor, or
  // DDS refuses; std::invalid_argument: a setting cannot be.
  CloudPublisher(Stream& stream, CloudSettings settings);
  // Says that the sensor has ended.
  ~CloudPublisher();
  CloudPublisher(const CloudPublisher&) = delete;
  CloudPublisher& operator=(const CloudPublisher&) = delete;

  // Each publishes a frame of width * height points, which are written straight into the memory
  // that is published, and returns whether it is out: false, and counted, when readers hold all
  // memory or DDS refuses it. `capture_time_ns` is of the wall clock; 0 = now. A span of another
  // size throws std::invalid_argument.
  //
  // Depth, row-major, in units of `unit_m` metres (0.001 = millimetres), 0 = no measurement; needs
  // intrinsics.
  bool publish_depth(std::span<const std::uint16_t> depth, float unit_m,
                     std::int64_t capture_time_ns = 0);
  // Depth in metres; NaN or 0 = no measurement.
  bool publish_depth(std::span<const float> depth_m, std::int64_t capture_time_ns = 0);
  // x, y, z of each point in metres, row-major; NaN = no measurement.
  bool publish_points(std::span<const float> xyz, std::int64_t capture_time_ns = 0);

  // The same in two steps, for who writes points himself: fill 3 * width * height floats of the
  // loan's room(), in any order, and hand it back. Empty, and counted, when there is no memory.
  [[nodiscard]] std::optional<CloudLoan> loan();
  bool publish(CloudLoan&& cloud, std::int64_t capture_time_ns = 0);

  // Who reads the clouds now: a publisher need not compute what nobody reads.
  [[nodiscard]] unsigned readers() const;
  // Whether the last frame that is not out found no memory; if not, DDS refused it.
  [[nodiscard]] bool lacked_memory() const;
  // Why there is no memory, and what to do about it; empty if there was.
  [[nodiscard]] std::string obstacle() const;
  [[nodiscard]] std::uint64_t published() const;
  [[nodiscard]] std::uint64_t dropped() const;
  [[nodiscard]] const CloudSettings& settings() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cleave
