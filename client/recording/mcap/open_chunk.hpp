// SPDX-License-Identifier: BSD-3-Clause
// A chunk, or a run of messages outside of chunks, with its messages found.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/mcap/compression/block.hpp"
#include "recording/mcap/format.hpp"
#include "recording/mcap/io/input_file.hpp"

namespace cleave::recording {

struct FoundMessage {
  std::uint64_t log_ns;
  ByteView content;  // of its record
};

struct OpenChunk {
  Block records;
  std::vector<FoundMessage> messages;  // point into the records
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::string damage;  // of a record, or why nothing behind these was found; empty = all is there
};

// Reads, decompresses and checks it. Throws DataError when nothing of it can be used.
[[nodiscard]] OpenChunk open_chunk(const InputFile& file, const ChunkPlace& place);

}  // namespace cleave::recording
