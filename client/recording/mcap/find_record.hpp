// SPDX-License-Identifier: BSD-3-Clause
// Behind damage: where does the next record begin?
#pragma once

#include <cstdint>
#include <optional>

#include "recording/mcap/io/input_file.hpp"

namespace cleave::recording {

// Which records are looked for. What looks like a message behind damage may lie within a damaged
// chunk, where no CRC vouches for it: a file that has chunks is not asked for any.
enum class Sought { any, not_in_chunks };

// The first place from `offset` on that looks like a record, and behind which more records follow;
// empty when there is none. Bytes are compared, nothing is decoded.
[[nodiscard]] std::optional<std::uint64_t> find_record(const InputFile& file, std::uint64_t offset,
                                                       Sought sought);

}  // namespace cleave::recording
