// SPDX-License-Identifier: BSD-3-Clause
// What only a look at all bytes of a file tells.
#pragma once

#include <cstdint>

#include "recording/mcap/contents.hpp"
#include "recording/mcap/io/input_file.hpp"

namespace cleave::recording {

// Of the bytes from `begin` to `end`, read a piece at a time.
[[nodiscard]] std::uint32_t crc32_of(const InputFile& file, std::uint64_t begin, std::uint64_t end);

// The content of its record, times, names and CRC included, held in memory whole. Throws DataError
// when its CRC is wrong.
[[nodiscard]] Bytes read_attachment(const InputFile& file, const Attachment& attachment);

// Notes the attachments whose CRC is wrong.
void check_attachments(const InputFile& file, Contents& contents);

// For a file that was read from end to end without meeting damage: is this what its statistics
// announce, and is the CRC of all its data right? Notes what is not.
void check_totals(const InputFile& file, Contents& contents, std::uint64_t messages);

}  // namespace cleave::recording
