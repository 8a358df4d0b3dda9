// SPDX-License-Identifier: BSD-3-Clause
// The other compression that MCAP knows: frames of LZ4. It is read, never written.
#pragma once

#include <cstddef>

#include "recording/mcap/compression/block.hpp"

namespace cleave::recording {

// Throws DataError unless the result has exactly `plain_bytes`.
[[nodiscard]] Block lz4_decompress(ByteView compressed, std::size_t plain_bytes);

}  // namespace cleave::recording
