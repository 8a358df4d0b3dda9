// SPDX-License-Identifier: BSD-3-Clause
// One sensor's recorded frames back onto its topics.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <string>

#include "idl/frame_key.hpp"
#include "libcleave/cloud_writer.hpp"
#include "libcleave/lossless_flow.hpp"
#include "libcleave/process/sensor_lock.hpp"
#include "libcleave/status.hpp"
#include "libcleave/writer.hpp"
#include "recording/frames/frame.hpp"

namespace cleave::client {

// What is published equals what was recorded, but for the times of CLOCK_MONOTONIC, which are those
// of now (a label map and a segment list name the new ones of their cloud), and for the epoch in a
// second pass, which rises. As the source of a sensor's clouds it holds the sensor's lock and
// publishes a grabber's status.
class SensorReplay {
 public:
  // `window`: lossless, so many clouds on their way to the segmenter at most. Throws
  // std::runtime_error: another process publishes the sensor's clouds.
  SensorReplay(Stream& stream, const std::string& sensor, const std::set<recording::Kind>& kinds,
               std::optional<std::uint32_t> window);

  // Call often: keeps the window moving and the status fresh.
  void update();
  // Whether the next frame may be published now.
  [[nodiscard]] bool ready() const;
  // False: not now, for readers hold all the shared memory. Throws recording::DataError for a frame
  // that cannot be published.
  [[nodiscard]] bool publish(const recording::Frame& frame, std::uint64_t pass);
  void set_state(NodeState state);

  // Somebody reads one of the topics; in lossless mode, a segmenter answers.
  [[nodiscard]] bool has_readers() const;
  [[nodiscard]] std::size_t in_flight() const { return flow_ ? flow_->in_flight() : 0; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Published {
    FrameKey frame;
    std::int64_t time_ns;
  };
  [[nodiscard]] bool publish(const recording::Cloud& cloud);
  [[nodiscard]] bool publish(const recording::Labels& labels);
  [[nodiscard]] bool publish(const recording::SegmentList& list);
  void set_epoch(FrameHeader& header) const { header.epoch += epoch_shift_; }
  [[nodiscard]] std::int64_t cloud_time_ns(const recording::FrameHeader& header) const;
  void publish_status();

  std::optional<SensorLock> lock_;
  std::optional<CloudWriter> clouds_;
  std::optional<LabelWriter> labels_;
  std::optional<Writer<SegmentList>> lists_;
  std::optional<LosslessFlow> flow_;
  StatusPublisher statuses_;
  NodeReport report_;
  Clock::time_point next_status_{};

  std::uint64_t pass_ = 0;
  std::uint32_t epoch_shift_ = 0;
  std::uint32_t last_epoch_ = 0;
  std::deque<Published> published_;  // the latest clouds
};

}  // namespace cleave::client
