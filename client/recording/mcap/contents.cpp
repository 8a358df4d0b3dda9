#include "recording/mcap/contents.hpp"

#include <algorithm>
#include <optional>

namespace cleave::recording {
namespace {

constexpr std::uint64_t end_bytes = record_prefix_bytes + footer_bytes + mcap_magic.size();

void check_magic(const InputFile& file) {
  Bytes start(std::min<std::uint64_t>(mcap_magic.size(), file.size()));
  file.read(0, start);
  if (!std::ranges::equal(start, bytes_of(mcap_magic))) {
    throw FileError(file.path().string() +
                    ": is no MCAP file: it does not begin as one; `cleave record` makes them");
  }
}

struct Summary {
  std::uint64_t offset;
  Bytes records;  // without the footer
};

// Empty where the file was cut off or its summary is damaged.
std::optional<Summary> read_summary(const InputFile& file) {
  if (file.size() < mcap_magic.size() + end_bytes) return std::nullopt;
  const std::uint64_t footer_offset = file.size() - end_bytes;
  const Bytes end = file.read(footer_offset, end_bytes);
  if (!std::ranges::equal(ByteView(end).last(mcap_magic.size()), bytes_of(mcap_magic))) {
    return std::nullopt;
  }
  ByteSource source(end);
  if (source.number<Opcode>() != Opcode::footer) return std::nullopt;
  if (source.number<std::uint64_t>() != footer_bytes) return std::nullopt;
  const auto offset = source.number<std::uint64_t>();
  (void)source.number<std::uint64_t>();
  const auto crc = source.number<std::uint32_t>();
  if (offset < mcap_magic.size() || offset > footer_offset) return std::nullopt;
  Summary summary{offset, file.read(offset, footer_offset - offset)};
  constexpr std::size_t before_crc = record_prefix_bytes + 2 * sizeof(std::uint64_t);
  const std::uint32_t found = crc32_of(ByteView(end).first(before_crc), crc32_of(summary.records));
  if (crc != 0 && crc != found) return std::nullopt;
  return summary;
}

ChunkPlace chunk_of_index(ByteSource& source) {
  ChunkPlace place;
  place.start_ns = source.number<std::uint64_t>();
  place.end_ns = source.number<std::uint64_t>();
  place.offset = source.number<std::uint64_t>();
  place.length = source.number<std::uint64_t>();
  return place;
}

std::map<std::uint16_t, std::uint64_t> counts_of_statistics(ByteSource& source) {
  (void)source.take(8 + 2 + 4 + 4 + 4 + 4 + 8 + 8);
  ByteSource entries(source.take(source.number<std::uint32_t>()));
  std::map<std::uint16_t, std::uint64_t> counts;
  while (entries.left() > 0) {
    const auto channel = entries.number<std::uint16_t>();
    counts[channel] = entries.number<std::uint64_t>();
  }
  return counts;
}

Metadata metadata_at(const InputFile& file, ByteSource& index) {
  const auto offset = index.number<std::uint64_t>();
  const auto length = index.number<std::uint64_t>();
  const Bytes record = file.read(offset, length);
  if (record.size() < record_prefix_bytes) throw DataError("a metadata record is too short");
  return decode_metadata(ByteView(record).subspan(record_prefix_bytes));
}

// Throws DataError.
Contents contents_of(const InputFile& file, const Summary& summary) {
  Contents contents;
  contents.indexed = true;
  std::map<std::uint16_t, std::string> topics;
  std::map<std::uint16_t, std::uint64_t> counts;
  ByteSource source(summary.records);
  while (source.left() > 0) {
    const auto opcode = source.number<Opcode>();
    const ByteView content = source.take(source.number<std::uint64_t>());
    ByteSource fields(content);
    if (opcode == Opcode::channel) {
      const Channel channel = decode_channel(content);
      topics[channel.id] = channel.topic;
    } else if (opcode == Opcode::chunk_index) {
      contents.chunks.push_back(chunk_of_index(fields));
    } else if (opcode == Opcode::statistics) {
      counts = counts_of_statistics(fields);
    } else if (opcode == Opcode::metadata_index) {
      contents.metadata.push_back(metadata_at(file, fields));
    }
  }
  for (const auto& [channel, count] : counts) contents.message_counts[topics[channel]] += count;
  std::ranges::sort(contents.chunks, {}, &ChunkPlace::offset);
  return contents;
}

}  // namespace

Contents read_contents(const InputFile& file) {
  check_magic(file);
  try {
    if (const std::optional<Summary> summary = read_summary(file)) {
      return contents_of(file, *summary);
    }
  } catch (const DataError&) {
    // Going through the file finds more than a summary that lies.
  }
  return scan_contents(file);
}

}  // namespace cleave::recording
