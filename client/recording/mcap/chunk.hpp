// SPDX-License-Identifier: BSD-3-Clause
// What is in a chunk.
#pragma once

#include "recording/mcap/compression/block.hpp"

namespace cleave::recording {

// The records of a chunk with this content, decompressed, with their CRC checked (0 = there is
// none). Throws DataError: a CRC that is wrong, a size that lies, or more than 1 GiB.
[[nodiscard]] Block plain_records(ByteView content);

}  // namespace cleave::recording
