// The end of a file: what lets a reader find everything without reading it all.
#include <algorithm>
#include <array>

#include "recording/mcap/writer.hpp"

namespace cleave::recording {
namespace {

// One kind of summary record, and where its group lies.
struct Group {
  Opcode opcode;
  Bytes records;
};

void append_counts(Bytes& to, const std::map<std::uint16_t, std::uint64_t>& counts) {
  append_number(to, static_cast<std::uint32_t>(counts.size() *
                                               (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
  for (const auto& [channel, count] : counts) {
    append_number(to, channel);
    append_number(to, count);
  }
}

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

Bytes McapWriter::statistics() const {
  std::map<std::uint16_t, std::uint64_t> counts;
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  for (const WrittenChunk& chunk : written_) {
    const bool first = &chunk == &written_.front();
    start_ns = first ? chunk.place.start_ns : std::min(start_ns, chunk.place.start_ns);
    end_ns = std::max(end_ns, chunk.place.end_ns);
    for (const auto& [channel, count] : chunk.message_counts) counts[channel] += count;
  }
  Bytes content;
  append_number(content, message_count_);
  append_number(content, static_cast<std::uint16_t>(schemas_.size()));
  append_number(content, static_cast<std::uint32_t>(channels_.size()));
  append_number(content, std::uint32_t{0});  // attachments
  append_number(content, static_cast<std::uint32_t>(metadata_.size()));
  append_number(content, static_cast<std::uint32_t>(written_.size()));
  append_number(content, start_ns);
  append_number(content, end_ns);
  append_counts(content, counts);
  return content;
}

// Summary and footer, for a file in which the summary begins at `offset`.
Bytes McapWriter::summary_section(std::uint64_t offset) const {
  std::array<Group, 5> groups = {Group{Opcode::schema, {}}, Group{Opcode::channel, {}},
                                 Group{Opcode::statistics, {}}, Group{Opcode::chunk_index, {}},
                                 Group{Opcode::metadata_index, {}}};
  for (const Schema& schema : schemas_) {
    append_record(groups[0].records, Opcode::schema, encode(schema));
  }
  for (const Channel& channel : channels_) {
    append_record(groups[1].records, Opcode::channel, encode(channel));
  }
  append_record(groups[2].records, Opcode::statistics, statistics());
  for (const WrittenChunk& chunk : written_) {
    Bytes content;
    append_number(content, chunk.place.start_ns);
    append_number(content, chunk.place.end_ns);
    append_number(content, chunk.place.offset);
    append_number(content, chunk.place.length);
    append_counts(content, chunk.index_offsets);
    append_number(content, chunk.index_bytes);
    append_string(content, "zstd");
    append_number(content, chunk.compressed_bytes);
    append_number(content, chunk.plain_bytes);
    append_record(groups[3].records, Opcode::chunk_index, content);
  }
  for (const MetadataPlace& place : metadata_) {
    Bytes content;
    append_number(content, place.offset);
    append_number(content, place.length);
    append_string(content, place.name);
    append_record(groups[4].records, Opcode::metadata_index, content);
  }

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
