// SPDX-License-Identifier: BSD-3-Clause
// The grabber: takes frames from a source, publishes them as clouds, and tells what became of each.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "libcleave/lossless_flow.hpp"
#include "libcleave/process/logging.hpp"
#include "libcleave/process/shutdown.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/wait_set.hpp"
#include "sensor/grabber/frame_book.hpp"
#include "sensor/grabber/frame_publisher.hpp"
#include "sensor/grabber/pacer.hpp"
#include "sensor/grabber/source_link.hpp"
#include "sensor/grabber/supervisor.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

struct GrabberOptions {
  std::string sensor;
  std::string coordinate_frame;
  std::string parent_frame;                 // empty = the sensor's pose is not known
  cleave_v1_Pose3 pose{};                   // of coordinate_frame in parent_frame
  std::uint32_t fps = 30;                   // pace of sources that have none of their own
  std::optional<std::uint32_t> window;      // frames in flight in lossless mode; empty = live
  std::optional<std::uint64_t> max_frames;  // end after so many published
  // A run that has an end, or may lose no frame, would not go on where it was if it started anew:
  // it does so only where it could not go on at all.
  bool endless = true;
};

enum class Ending {
  done,       // the source ended, enough frames were published, or a signal asked
  failed,     // the source could not be opened, and nobody else has it
  start_anew  // only a fresh process joins the RouDi that is there now, or survives the one that
              // ends
};

// Nothing is published while no reader is matched: the frames of a camera are then dropped and
// counted, recordings wait. In lossless mode a segmenter must be matched, too.
//
// All that uses the source happens on the thread that calls run().
class Grabber {
 public:
  // All must outlive the grabber.
  Grabber(const GrabberOptions& options, Stream& stream, Source& source, Shutdown& shutdown);
  ~Grabber();
  Grabber(const Grabber&) = delete;
  Grabber& operator=(const Grabber&) = delete;

  // After the last frame it lingers: in lossless mode until all segment lists are back, else for a
  // second, so that readers can take what is on its way.
  [[nodiscard]] Ending run();

 private:
  using Clock = std::chrono::steady_clock;
  void step();
  void update(Clock::time_point now);
  [[nodiscard]] bool has_readers() const;
  [[nodiscard]] bool must_start_anew() const;
  std::chrono::milliseconds until_next(Clock::time_point now);
  void take_frame();
  void handle(const Frame& frame);
  void drop_too_large(const Frame& frame);
  [[nodiscard]] Publication publish(const Frame& frame);
  void linger(std::chrono::milliseconds at_most);
  [[nodiscard]] bool ended() const { return supervisor_.state() == NodeState::ended; }

  GrabberOptions options_;
  Source& source_;
  Shutdown& shutdown_;
  FrameBook book_;
  FramePublisher publisher_;
  std::optional<LosslessFlow> flow_;
  Supervisor supervisor_;
  SourceLink link_;
  Pacer pacer_;
  LogLimiter log_limiter_;
  bool said_waiting_ = false;
  WaitSet wait_set_;  // last: it goes before the readers that it watches
};

}  // namespace cleave::sensor
