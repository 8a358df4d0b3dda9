// SPDX-License-Identifier: BSD-3-Clause
// A sensor's topics into a recording, until there is a reason to stop.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "cleave/record/background_writer.hpp"
#include "libcleave/cloud_reader.hpp"
#include "libcleave/process/shutdown.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/status.hpp"
#include "libcleave/wait_set.hpp"

namespace cleave::client {

class RecordSession {
 public:
  // Reads these topics and hands them to `writer`, which must outlive this.
  RecordSession(Stream& stream, const std::string& sensor, const std::set<recording::Kind>& topics,
                BackgroundWriter& writer);

  // Until shutdown is requested, `duration_s` has passed since the first frame, the writer has
  // stopped, or the source has ended and no frame has come for two seconds. Why, for people.
  // `on_tick` is called several times a second.
  [[nodiscard]] std::string run(Shutdown& shutdown, std::optional<double> duration_s,
                                const std::function<void()>& on_tick);

  // Clouds that the sensor published and that did not reach this process.
  [[nodiscard]] std::uint64_t lost_clouds() const { return lost_clouds_; }
  // Since the first frame.
  [[nodiscard]] double elapsed_s() const;

 private:
  using Clock = std::chrono::steady_clock;
  template <class Message>
  void offer(const Message& message);
  void take_clouds();
  void take_labels();
  void take_lists();
  void take_statuses();
  void note(const FrameHeader& header);
  [[nodiscard]] std::string reason_to_stop(const Shutdown& shutdown,
                                           std::optional<double> duration_s) const;

  std::string sensor_;
  BackgroundWriter& writer_;
  std::optional<CloudReader> clouds_;
  std::optional<LabelReader> labels_;
  std::optional<Reader<SegmentList>> lists_;
  Reader<NodeStatus> statuses_;
  WaitSet wait_set_;

  std::optional<Clock::time_point> first_frame_;
  Clock::time_point last_frame_{};
  bool source_ended_ = false;
  std::uint32_t epoch_ = 0;
  std::uint64_t frame_id_ = 0;  // of the last cloud; 0 = none yet
  std::uint64_t lost_clouds_ = 0;
};

}  // namespace cleave::client
