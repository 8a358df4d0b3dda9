// SPDX-License-Identifier: BSD-3-Clause
// A segment list as it came into the hands of this client.
#pragma once

#include <chrono>

#include "cleave/stream/stream_summary.hpp"
#include "libcleave/types.hpp"

namespace cleave::client {

// The latency is meant for lists from this machine: it compares with this machine's monotonic
// clock.
[[nodiscard]] ListArrival arrival_of(const SegmentList& list,
                                     std::chrono::steady_clock::time_point now);

}  // namespace cleave::client
