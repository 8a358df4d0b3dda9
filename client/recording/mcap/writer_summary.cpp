// SPDX-License-Identifier: BSD-3-Clause
// The end of a file: what lets a reader find everything without reading it all.
#include <algorithm>
#include <array>
#include <utility>

#include "recording/mcap/writer.hpp"

namespace cleave::recording {
namespace {

// One kind of summary record, and where its group lies.
struct Group {
  Opcode opcode;
  Bytes records;
};

}  // namespace

void McapWriter::close() {
  flush();
  Bytes data_end;
  append_number(data_end, file_.crc());
  Bytes end;
  append_record(end, Opcode::data_end, data_end);
  append(end, summary_section(file_.size() + end.size()));
  append(end, bytes_of(mcap_magic));
  file_.append(end);
  file_.sync();
}

Statistics McapWriter::statistics() const {
  Statistics statistics;
  statistics.messages = message_count_;
  statistics.schemas = static_cast<std::uint16_t>(schemas_.size());
  statistics.channels = static_cast<std::uint32_t>(channels_.size());
  statistics.attachments = static_cast<std::uint32_t>(attachments_.size());
  statistics.metadata = static_cast<std::uint32_t>(metadata_.size());
  statistics.chunks = static_cast<std::uint32_t>(written_.size());
  if (!written_.empty()) statistics.start_ns = written_.front().place.start_ns;
  for (const WrittenChunk& chunk : written_) {
    statistics.start_ns = std::min(statistics.start_ns, chunk.place.start_ns);
    statistics.end_ns = std::max(statistics.end_ns, chunk.place.end_ns);
    for (const auto& [channel, count] : chunk.message_counts) {
      statistics.message_counts[channel] += count;
    }
  }
  return statistics;
}

Bytes McapWriter::chunk_index_records() const {
  Bytes records;
  for (const WrittenChunk& chunk : written_) {
    Bytes content;
    append_number(content, chunk.place.start_ns);
    append_number(content, chunk.place.end_ns);
    append_number(content, chunk.place.offset);
    append_number(content, chunk.place.length);
    append_by_channel(content, chunk.index_offsets);
    append_number(content, chunk.index_bytes);
    append_string(content, "zstd");
    append_number(content, chunk.compressed_bytes);
    append_number(content, chunk.plain_bytes);
    append_record(records, Opcode::chunk_index, content);
  }
  return records;
}

Bytes McapWriter::attachment_index_records() const {
  Bytes records;
  for (const auto& [place, attachment] : attachments_) {
    Bytes content;
    append_number(content, place.offset);
    append_number(content, place.length);
    append_number(content, attachment.log_ns);
    append_number(content, attachment.create_ns);
    append_number(content, attachment.data_bytes);
    append_string(content, attachment.name);
    append_string(content, attachment.media_type);
    append_record(records, Opcode::attachment_index, content);
  }
  return records;
}

Bytes McapWriter::metadata_index_records() const {
  Bytes records;
  for (const auto& [place, name] : metadata_) {
    Bytes content;
    append_number(content, place.offset);
    append_number(content, place.length);
    append_string(content, name);
    append_record(records, Opcode::metadata_index, content);
  }
  return records;
}

// Summary and footer, for a file in which the summary begins at `offset`.
Bytes McapWriter::summary_section(std::uint64_t offset) const {
  Bytes schemas;
  for (const auto& [id, schema] : schemas_) append_record(schemas, Opcode::schema, encode(schema));
  Bytes channels;
  for (const auto& [id, channel] : channels_) {
    append_record(channels, Opcode::channel, encode(channel));
  }
  Bytes numbers;
  append_record(numbers, Opcode::statistics, encode(statistics()));
  const std::array<Group, 6> groups = {Group{Opcode::schema, std::move(schemas)},
                                       Group{Opcode::channel, std::move(channels)},
                                       Group{Opcode::statistics, std::move(numbers)},
                                       Group{Opcode::chunk_index, chunk_index_records()},
                                       Group{Opcode::attachment_index, attachment_index_records()},
                                       Group{Opcode::metadata_index, metadata_index_records()}};

  Bytes summary;
  Bytes offsets;
  for (const Group& group : groups) {
    if (group.records.empty()) continue;
    Bytes content;
    append_number(content, group.opcode);
    append_number(content, offset + summary.size());
    append_number(content, std::uint64_t{group.records.size()});
    append_record(offsets, Opcode::summary_offset, content);
    append(summary, group.records);
  }
  const std::uint64_t offsets_start = offset + summary.size();
  append(summary, offsets);

  // The CRC covers the summary and the footer up to itself.
  append_number(summary, Opcode::footer);
  append_number(summary, std::uint64_t{footer_bytes});
  append_number(summary, offset);
  append_number(summary, offsets_start);
  append_number(summary, crc32_of(summary));
  return summary;
}

}  // namespace cleave::recording
