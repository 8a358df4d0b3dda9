// SPDX-License-Identifier: BSD-3-Clause
// Segments as foxglove::SceneUpdate: boxes in the colours of their labels, for 3D views.
#pragma once

#include "recording/frames/frame.hpp"
#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

// One entity, which replaces the frame's before: a translucent box and the label's number a
// segment.
[[nodiscard]] Bytes scene_update_message(const SegmentList& list);

}  // namespace cleave::recording
