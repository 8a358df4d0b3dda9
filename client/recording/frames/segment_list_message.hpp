// SPDX-License-Identifier: BSD-3-Clause
// The contract's SegmentList as CDR: the bytes that DDS puts on the wire.
#pragma once

#include "recording/cdr/lacking_fields.hpp"
#include "recording/frames/frame.hpp"
#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

[[nodiscard]] Bytes segment_list_message(const SegmentList& list);
// Throws DataError.
[[nodiscard]] SegmentList read_segment_list(ByteView message, const LackingFields& lacking = {});

}  // namespace cleave::recording
