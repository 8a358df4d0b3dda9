// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/segment_message.hpp"

#include <spdlog/fmt/fmt.h>

#include "console/segment_table.hpp"
#include "console/table.hpp"

namespace cleave::client {

std::string text_of(const recording::SegmentList& list) {
  const recording::FrameHeader& h = list.header;
  constexpr double ns_per_s = 1e9;
  std::string text =
      fmt::format("frame {}  epoch {}  sensor {}  {} x {} points  in {}  captured at {:.3f} s\n",
                  h.frame_id, h.epoch, printable(h.sensor), h.width, h.height,
                  printable(h.coordinate_frame), static_cast<double>(h.capture_time_ns) / ns_per_s);
  if (list.outcome != recording::FrameOutcome::segmented) {
    return text + fmt::format("rejected: {}\n\n", name_of(list.outcome));
  }
  text +=
      fmt::format("segmented: {} segments, {} borders  waited {:.1f} ms, took {:.1f} ms\n",
                  list.segments.size(), list.borders.size(), list.queue_ms, list.segmentation_ms);
  return text + segment_table(list) + '\n';
}

}  // namespace cleave::client
