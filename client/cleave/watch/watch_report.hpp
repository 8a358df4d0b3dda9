// SPDX-License-Identifier: BSD-3-Clause
// What `cleave watch` says: a line a frame, and a summary at the end.
#pragma once

#include <string>

#include "cleave/stream/stream_summary.hpp"
#include "cleave/watch/frame_account.hpp"
#include "console/json.hpp"

namespace cleave::client {

struct WatchSummary {
  std::string sensor;
  Transport transport = Transport::network;
  std::string transport_reason;
  bool zero_copy = false;  // every cloud into the segmenter and every label map into this client
  Account account;
  double fps = 0;
  Percentiles latency_ms;  // publication of the cloud to the segment list in hand
  Percentiles segments;
  double segmenter_cpu = 0;  // of one core, from the first frame to the last
};

// "frame 123   14 segments   29.9 Hz   41.3 ms   zero copy yes   dropped 0   rejected 0"
[[nodiscard]] std::string frame_line(const ListArrival& arrival, double rate_hz, bool zero_copy,
                                     const Account& account);

[[nodiscard]] std::string text_of(const WatchSummary& summary);
[[nodiscard]] Json json_of(const WatchSummary& summary);

}  // namespace cleave::client
