// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/open_chunk.hpp"

#include "recording/mcap/chunk.hpp"

namespace cleave::recording {
namespace {

Block records_at(const InputFile& file, const ChunkPlace& place) {
  if (place.loose) {
    Block records(static_cast<std::size_t>(place.length));
    file.read(place.offset, records.bytes());
    return records;
  }
  return plain_records(
      ByteView(file.read(place.offset, place.length)).subspan(record_prefix_bytes));
}

FoundMessage message_in(ByteView content) {
  ByteSource source(content);
  (void)source.take(2 + 4);  // channel and number
  const auto log_ns = source.number<std::uint64_t>();
  (void)source.take(8);
  return {log_ns, content};
}

void take(OpenChunk& chunk, Opcode opcode, ByteView content) {
  if (opcode == Opcode::schema) chunk.schemas.push_back(decode_schema(content));
  if (opcode == Opcode::channel) chunk.channels.push_back(decode_channel(content));
  if (opcode == Opcode::message) chunk.messages.push_back(message_in(content));
}

// Throws DataError where no further record can be found.
void find_records(OpenChunk& chunk) {
  ByteSource source(chunk.records.view());
  while (source.left() > 0) {
    const auto opcode = source.number<Opcode>();
    const ByteView content = source.take(source.number<std::uint64_t>());
    try {
      take(chunk, opcode, content);
    } catch (const DataError& error) {
      chunk.damage = error.what();
    }
  }
}

}  // namespace

OpenChunk open_chunk(const InputFile& file, const ChunkPlace& place) {
  OpenChunk chunk;
  chunk.records = records_at(file, place);
  try {
    find_records(chunk);
  } catch (const DataError& error) {
    chunk.damage = error.what();
  }
  return chunk;
}

}  // namespace cleave::recording
