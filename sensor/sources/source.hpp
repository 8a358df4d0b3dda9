// SPDX-License-Identifier: BSD-3-Clause
// Where frames come from: a camera, or files. sensor::Frame is what a source says of one before its
// points are written.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "idl/capacity.hpp"
#include "recording/cloud/projection.hpp"

namespace cleave::sensor {

using recording::Intrinsics;  // all 0 = not an image

// A frame without its points. (recording::Frame is a message on file, service::Frame a cloud that
// waits for a worker.)
struct Frame {
  std::uint32_t width = 0;
  std::uint32_t height = 0;  // 1 = unorganised
  Intrinsics intrinsics;
  std::int64_t capture_time_ns = 0;  // wall clock
  std::uint64_t device_time_us = 0;  // the sensor's own clock; 0 where there is none
  // The first frame after a restart of the recording or of the sensor's clock.
  bool begins_epoch = false;
  std::int64_t arrival_time_ns = 0;  // CLOCK_MONOTONIC; the grabber's, not the source's, to set
  // Of a recording with a timing of its own: from this frame to the next one.
  std::optional<std::chrono::nanoseconds> until_next = {};
};

enum class Poll {
  frame,    // a frame is held: write_points() writes its points
  timeout,  // none yet
  end,      // there will be no more
  lost      // the device went away or fell silent; open() may bring it back
};

// Since construction.
struct SourceCounts {
  std::uint64_t sensor_drops = 0;                 // frames that the device numbered and nobody got
  std::map<std::string, std::uint64_t> unusable;  // files or frames, by cause
};

// What failed, why, and what to do about it; empty = nothing failed.
using Failure = std::optional<std::string>;

// One thread uses a source, from open() to its destruction.
class Source {
 public:
  Source() = default;
  virtual ~Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  // Starts delivery, or starts it again after `lost`.
  [[nodiscard]] virtual Failure open() = 0;
  // The next frame, waited for up to `timeout`. The frame held before is given up. After `lost`,
  // last_error() says what happened.
  [[nodiscard]] virtual Poll next(std::chrono::milliseconds timeout, Frame& frame) = 0;
  // Writes width * height points x, y, z of the held frame: metres, optical frame (x right, y down,
  // z forward), row-major, NaN NaN NaN = no measurement.
  virtual void write_points(float* xyz) = 0;
  // True: the device paces, and frames that are not read are gone. False: the caller paces.
  [[nodiscard]] virtual bool realtime() const = 0;
  [[nodiscard]] virtual SourceCounts counts() const = 0;
  [[nodiscard]] virtual std::string last_error() const = 0;
  // After open() failed: the device is there, but somebody else has it. It may be free soon.
  [[nodiscard]] virtual bool in_use() const { return false; }
};

}  // namespace cleave::sensor
