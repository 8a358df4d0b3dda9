// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/lossless_flow.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace cleave {
namespace {

// Lists may come in bursts while this process sleeps; one that is overwritten costs a resend.
constexpr ReaderDepth list_depth{16};

// False: not now.
bool publish_again(const KeptFrame& frame, CloudWriter& writer) {
  std::optional<CloudLoan> cloud = writer.loan(point_count(frame.header));
  if (!cloud) return false;
  cloud->header() = frame.header;
  std::ranges::copy(frame.xyz, cloud->room().begin());
  cloud->header().publication_time_ns = monotonic_now_ns();
  return std::move(*cloud).publish();
}

}  // namespace

LosslessFlow::LosslessFlow(Stream& stream, const std::string& sensor, std::uint32_t window)
    : segments_(stream, sensor, list_depth), window_(window) {}

void LosslessFlow::update(Clock::time_point now, CloudWriter& writer) {
  while (const auto list = segments_.take()) window_.returned(key_of((*list)->header), now);
  std::erase_if(kept_, [&](const KeptFrame& f) { return !window_.contains(key_of(f.header)); });
  window_.update(now, segmenters());
  if (writer.matched_readers() == 0) return;
  while (const std::optional<FrameKey> due = window_.to_resend()) {
    const auto frame = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const KeptFrame& f) { return key_of(f.header) == *due; });
    spdlog::info("publishing frame {} again: its segment list has not come back", due->frame_id);
    // What is not accepted now is due again in the next round.
    if (!publish_again(*frame, writer)) return;
    window_.published(*due, now);
  }
}

void LosslessFlow::published(KeptFrame frame, Clock::time_point now) {
  window_.published(key_of(frame.header), now);
  kept_.push_back(std::move(frame));
}

}  // namespace cleave
