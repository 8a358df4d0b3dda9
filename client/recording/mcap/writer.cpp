// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cleave::recording {
namespace {

constexpr char library[] = "cleave";

template <class Definition>
std::uint16_t next_id(const std::map<std::uint16_t, Definition>& definitions, std::uint16_t first) {
  return definitions.empty() ? first : static_cast<std::uint16_t>(definitions.rbegin()->first + 1);
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path, std::size_t chunk_bytes,
                       std::string_view profile)
    : file_(path), chunk_bytes_(chunk_bytes) {
  Bytes content;
  append_string(content, profile);
  append_string(content, library);
  Bytes start;
  append(start, bytes_of(mcap_magic));
  append_record(start, Opcode::header, content);
  file_.append(start);
}

std::uint16_t McapWriter::add_schema(std::string name, std::string encoding, std::string text) {
  const std::uint16_t id = next_id(schemas_, 1);
  schemas_[id] = {id, std::move(name), std::move(encoding), std::move(text)};
  return id;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema_id, std::string topic,
                                      std::string message_encoding, Texts metadata) {
  const std::uint16_t id = next_id(channels_, 0);
  channels_[id] = {id, schema_id, std::move(topic), std::move(message_encoding),
                   std::move(metadata)};
  return id;
}

// The channel's records go into every chunk that has a message of it.
void McapWriter::introduce(std::uint16_t channel_id) {
  if (!introduced_.insert(channel_id).second) return;
  const Channel& channel = channels_.at(channel_id);
  if (channel.schema_id != 0) {
    append_record(chunk_, Opcode::schema, encode(schemas_.at(channel.schema_id)));
  }
  append_record(chunk_, Opcode::channel, encode(channel));
}

void McapWriter::write(std::uint16_t channel_id, std::uint32_t sequence, const MessageTimes& times,
                       ByteView data) {
  introduce(channel_id);
  if (index_.empty()) {
    chunk_start_ns_ = times.log_ns;
    chunk_end_ns_ = times.log_ns;
  }
  chunk_start_ns_ = std::min(chunk_start_ns_, times.log_ns);
  chunk_end_ns_ = std::max(chunk_end_ns_, times.log_ns);
  index_[channel_id].push_back({times.log_ns, chunk_.size()});

  constexpr std::size_t fields_bytes = 2 + 4 + 8 + 8;
  append_number(chunk_, Opcode::message);
  append_number(chunk_, std::uint64_t{fields_bytes + data.size()});
  append_number(chunk_, channel_id);
  append_number(chunk_, sequence);
  append_number(chunk_, times.log_ns);
  append_number(chunk_, times.publish_ns);
  append(chunk_, data);
}

void McapWriter::end_group() {
  if (chunk_.size() >= chunk_bytes_) flush();
}

void McapWriter::flush() {
  if (index_.empty()) return;
  try {
    write_chunk();
  } catch (...) {
    start_chunk();
    throw;
  }
  start_chunk();
}

void McapWriter::start_chunk() {
  chunk_.clear();
  introduced_.clear();
  index_.clear();
}

void McapWriter::write_chunk() {
  const Bytes compressed = compressor_.compress(chunk_);
  Bytes content;
  content.reserve(compressed.size() + 64);
  append_number(content, chunk_start_ns_);
  append_number(content, chunk_end_ns_);
  append_number(content, std::uint64_t{chunk_.size()});
  append_number(content, crc32_of(chunk_));
  append_string(content, "zstd");
  append_number(content, std::uint64_t{compressed.size()});
  append(content, compressed);

  WrittenChunk written;
  Bytes records;
  records.reserve(content.size() + 4096);
  append_record(records, Opcode::chunk, content);
  written.place = {file_.size(), records.size(), chunk_start_ns_, chunk_end_ns_};
  written.compressed_bytes = compressed.size();
  written.plain_bytes = chunk_.size();
  append(records, chunk_indexes(file_.size() + records.size(), written));
  file_.append(records);

  for (const auto& [channel, count] : written.message_counts) message_count_ += count;
  written_.push_back(std::move(written));
}

// The message index records of the open chunk, which begin at `offset` of the file.
Bytes McapWriter::chunk_indexes(std::uint64_t offset, WrittenChunk& written) const {
  Bytes records;
  for (const auto& [channel, entries] : index_) {
    Bytes content;
    append_number(content, channel);
    append_number(content, static_cast<std::uint32_t>(entries.size() * 2 * sizeof(std::uint64_t)));
    for (const IndexEntry& entry : entries) {
      append_number(content, entry.log_ns);
      append_number(content, entry.offset);
    }
    written.index_offsets[channel] = offset + records.size();
    written.message_counts[channel] = entries.size();
    append_record(records, Opcode::message_index, content);
  }
  written.index_bytes = records.size();
  return records;
}

McapWriter::RecordPlace McapWriter::put(Opcode opcode, ByteView content) {
  flush();
  Bytes record;
  append_record(record, opcode, content);
  const RecordPlace place{file_.size(), record.size()};
  file_.append(record);
  return place;
}

void McapWriter::add_metadata(const Metadata& metadata) {
  metadata_.emplace_back(put(Opcode::metadata, encode(metadata)), metadata.name);
}

void McapWriter::add_attachment(const Attachment& attachment, ByteView content) {
  attachments_.emplace_back(put(Opcode::attachment, content), attachment);
}

}  // namespace cleave::recording
