// SPDX-License-Identifier: BSD-3-Clause
// cleave::recording::Labels: what a recording says of a label map beyond its Image.
#pragma once

#include "recording/frames/frame.hpp"
#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

// All but the labels themselves.
[[nodiscard]] Bytes labels_message(const Labels& labels);
// Throws DataError.
[[nodiscard]] Labels read_labels_message(ByteView message);

}  // namespace cleave::recording
