// SPDX-License-Identifier: BSD-3-Clause
// The contract's FrameHeader as CDR.
#pragma once

#include "recording/cdr/cdr.hpp"
#include "recording/cdr/lacking_fields.hpp"
#include "recording/frames/frame.hpp"

namespace cleave::recording {

// Throws DataError if a name has more than 63 characters.
void write_header(CdrWriter& cdr, const FrameHeader& header);

// Throws DataError: too short, a name without end, or a size beyond the contract's capacity.
[[nodiscard]] FrameHeader read_header(CdrReader& cdr, const LackingFields& lacking);

// Throws DataError for a size beyond the contract's capacity.
void check_capacity(const FrameHeader& header);

}  // namespace cleave::recording
