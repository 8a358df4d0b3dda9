// SPDX-License-Identifier: BSD-3-Clause
// Segment lists for people.
#pragma once

#include <string>

#include "recording/frames/frame.hpp"

namespace cleave::client {

// What `cleave echo` prints: a line of the header, a line of the outcome, a table of the segments.
[[nodiscard]] std::string text_of(const recording::SegmentList& list);

}  // namespace cleave::client
