// SPDX-License-Identifier: BSD-3-Clause
// Whole frames of a sensor, one after the other:
//
//   cleave::FrameReader frames(stream, "camera");
//   while (const auto frame = frames.next(std::chrono::seconds(5))) use(*frame);
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "libcleave/cloud_reader.hpp"
#include "libcleave/frames/frame_joiner.hpp"
#include "libcleave/list_reader.hpp"
#include "libcleave/ready_descriptor.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// From one thread, but for wake(). A frame's samples must not outlive this; while one is held, two
// chunks are out of the pool, so hold few.
class FrameReader {
 public:
  // `stream` outlives this. Throws std::runtime_error.
  FrameReader(Stream& stream, std::string_view sensor);

  // The oldest frame whose cloud, label map and segment list are all here; else the first that
  // comes before `timeout` is over (a negative one never is). Empty: none came, or a signal's
  // handler ran, or wake() was called. Frames that are not fetched in time are given up, as are
  // those of which a part was lost: what comes out is in order, but may have gaps.
  [[nodiscard]] std::optional<CompleteFrame> next(std::chrono::milliseconds timeout);
  // Ends the current next(), or the one to come. From any thread.
  void wake();

  // Readable while a frame may be complete, for poll(). Call next(0ms) until it is empty, which
  // makes it unreadable again.
  [[nodiscard]] int descriptor() const { return ready_.get(); }
  // Samples given up because the rest of their frame did not come.
  [[nodiscard]] std::uint64_t given_up() const { return joiner_.given_up(); }
  // Segmenters, and sensors, that are alive now.
  [[nodiscard]] unsigned live_segmenters() const { return lists_.live_writers(); }
  [[nodiscard]] unsigned live_sensors() const { return clouds_.live_writers(); }

 private:
  [[nodiscard]] std::optional<CompleteFrame> take();

  ReadyDescriptor ready_;
  CloudReader clouds_;
  LabelReader labels_;
  ListReader lists_;
  FrameJoiner joiner_;
  std::atomic<bool> woken_ = false;
};

}  // namespace cleave
