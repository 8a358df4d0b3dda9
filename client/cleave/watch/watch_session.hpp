// SPDX-License-Identifier: BSD-3-Clause
// A sensor's stream, followed from all of its topics until there is a reason to stop.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "cleave/stream/stream_summary.hpp"
#include "cleave/watch/cpu_share.hpp"
#include "cleave/watch/frame_account.hpp"
#include "cleave/watch/watch_end.hpp"
#include "cleave/watch/watch_report.hpp"
#include "console/picture/depth_image.hpp"
#include "libcleave/cloud_reader.hpp"
#include "libcleave/frames/joiner.hpp"
#include "libcleave/process/shutdown.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"
#include "recording/frames/frame.hpp"

namespace cleave::client {

class WatchSession {
 public:
  // `with_clouds`: also reads clouds, and keeps the last one with its label map for a picture.
  WatchSession(Stream& stream, const std::string& sensor, bool with_clouds);

  // Follows the stream; `on_frame` gets a line for every segment list.
  [[nodiscard]] WatchEnd run(Shutdown& shutdown, std::optional<std::uint64_t> frames,
                             const std::function<void(const std::string&)>& on_frame);

  [[nodiscard]] WatchSummary summary() const;
  [[nodiscard]] const FrameAccount& account() const { return account_; }
  // Of the last segment list.
  [[nodiscard]] const recording::SegmentList& last_segments() const { return last_segments_; }
  // The last cloud with its labels; empty if none came, or if their sizes cannot be.
  [[nodiscard]] std::optional<DepthImage> last_image() const;

 private:
  void take_statuses();
  void take_label_maps();
  void take_clouds();
  void take_lists(EndCondition& condition, const std::function<void(const std::string&)>& on_frame);
  void await_segmenter_status();
  [[nodiscard]] bool zero_copy() const;

  Stream& stream_;
  std::string sensor_;
  Reader<SegmentList> lists_;
  Reader<NodeStatus> statuses_;
  LabelReader label_maps_;
  std::optional<CloudReader> clouds_;
  WaitSet wait_set_;
  Joiner joiner_;
  std::optional<JoinedFrame> last_frame_;

  FrameAccount account_;
  CpuShare segmenter_cpu_;
  StreamSummary summary_;
  std::uint64_t label_maps_copied_ = 0;
  std::uint64_t segmenter_statuses_ = 0;
  recording::SegmentList last_segments_;
};

}  // namespace cleave::client
