// SPDX-License-Identifier: BSD-3-Clause
// service::Frame, a cloud that waits for a worker, and FinishedFrame, its results until they are
// published.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "libcleave/types.hpp"
#include "segmentation/segmentation.hpp"
#include "segmenter/pipeline/causes.hpp"
#include "segmenter/pipeline/frame_ledger.hpp"
#include "segmenter/pipeline/frame_queue.hpp"
#include "segmenter/pipeline/result_sink.hpp"

namespace cleave::service {

// A cloud where the transport put it, which may be the writer's own memory; it stays there until
// the last owner lets it go.
struct ReceivedCloud {
  std::shared_ptr<const void> owner;
  const FrameHeader* header = nullptr;
  std::span<const float> room;  // x, y, z of as many points as its type has room for
  bool zero_copy = false;
};

// Checked, and waiting for a worker. Of the cloud only the points are read: the header is a private
// copy.
struct Frame {
  std::uint64_t ticket = 0;
  FrameHeader header{};
  ReceivedCloud cloud;
  std::int64_t accepted_ns = 0;  // CLOCK_MONOTONIC
};

// Waiting for the frames before it to be published.
struct FinishedFrame {
  FrameHeader header{};
  std::int64_t accepted_ns = 0;  // CLOCK_MONOTONIC
  std::optional<RejectCause> rejected;
  FrameQueue<Frame>::Place place;  // lets the next frame in when this one, and its loan, is gone
  std::unique_ptr<LabelMemory> labels;  // empty for a rejected frame
  segmentation::Segmentation segmentation;
  float queue_ms = 0;
  float segmentation_ms = 0;
};

}  // namespace cleave::service
