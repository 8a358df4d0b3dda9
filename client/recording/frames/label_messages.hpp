// SPDX-License-Identifier: BSD-3-Clause
// cleave::recording::Labels: what a recording says of a label map beyond its Image.
#pragma once

#include "recording/cdr/lacking_fields.hpp"
#include "recording/frames/frame.hpp"
#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

// All but the labels themselves.
[[nodiscard]] Bytes labels_message(const Labels& labels);
// Throws DataError.
[[nodiscard]] Labels read_labels_message(ByteView message, const LackingFields& lacking = {});

}  // namespace cleave::recording
