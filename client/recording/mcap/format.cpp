// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/format.hpp"

#include <zlib.h>

namespace cleave::recording {

void append_record(Bytes& to, Opcode opcode, ByteView content) {
  append_number(to, opcode);
  append_number(to, std::uint64_t{content.size()});
  append(to, content);
}

void append_texts(Bytes& to, const Texts& texts) {
  Bytes entries;
  for (const auto& [key, value] : texts) {
    append_string(entries, key);
    append_string(entries, value);
  }
  append_number(to, static_cast<std::uint32_t>(entries.size()));
  append(to, entries);
}

Texts decode_texts(ByteSource& source) {
  ByteSource entries(source.take(source.number<std::uint32_t>()));
  Texts texts;
  while (entries.left() > 0) {
    std::string key = entries.string();
    texts[std::move(key)] = entries.string();
  }
  return texts;
}

void append_by_channel(Bytes& to, const std::map<std::uint16_t, std::uint64_t>& numbers) {
  append_number(to, static_cast<std::uint32_t>(numbers.size() *
                                               (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
  for (const auto& [channel, number] : numbers) {
    append_number(to, channel);
    append_number(to, number);
  }
}

Bytes encode(const Schema& schema) {
  Bytes content;
  append_number(content, schema.id);
  append_string(content, schema.name);
  append_string(content, schema.encoding);
  append_string(content, schema.text);
  return content;
}

Bytes encode(const Channel& channel) {
  Bytes content;
  append_number(content, channel.id);
  append_number(content, channel.schema_id);
  append_string(content, channel.topic);
  append_string(content, channel.message_encoding);
  append_texts(content, channel.metadata);
  return content;
}

Bytes encode(const Metadata& metadata) {
  Bytes content;
  append_string(content, metadata.name);
  append_texts(content, metadata.entries);
  return content;
}

Bytes encode(const Statistics& statistics) {
  Bytes content;
  append_number(content, statistics.messages);
  append_number(content, statistics.schemas);
  append_number(content, statistics.channels);
  append_number(content, statistics.attachments);
  append_number(content, statistics.metadata);
  append_number(content, statistics.chunks);
  append_number(content, statistics.start_ns);
  append_number(content, statistics.end_ns);
  append_by_channel(content, statistics.message_counts);
  return content;
}

Schema decode_schema(ByteView content) {
  ByteSource source(content);
  Schema schema;
  schema.id = source.number<std::uint16_t>();
  schema.name = source.string();
  schema.encoding = source.string();
  schema.text = source.string();
  return schema;
}

Channel decode_channel(ByteView content) {
  ByteSource source(content);
  Channel channel;
  channel.id = source.number<std::uint16_t>();
  channel.schema_id = source.number<std::uint16_t>();
  channel.topic = source.string();
  channel.message_encoding = source.string();
  channel.metadata = decode_texts(source);
  return channel;
}

Metadata decode_metadata(ByteView content) {
  ByteSource source(content);
  Metadata metadata;
  metadata.name = source.string();
  metadata.entries = decode_texts(source);
  return metadata;
}

Statistics decode_statistics(ByteView content) {
  ByteSource source(content);
  Statistics statistics;
  statistics.messages = source.number<std::uint64_t>();
  statistics.schemas = source.number<std::uint16_t>();
  statistics.channels = source.number<std::uint32_t>();
  statistics.attachments = source.number<std::uint32_t>();
  statistics.metadata = source.number<std::uint32_t>();
  statistics.chunks = source.number<std::uint32_t>();
  statistics.start_ns = source.number<std::uint64_t>();
  statistics.end_ns = source.number<std::uint64_t>();
  ByteSource counts(source.take(source.number<std::uint32_t>()));
  while (counts.left() > 0) {
    const auto channel = counts.number<std::uint16_t>();
    statistics.message_counts[channel] = counts.number<std::uint64_t>();
  }
  return statistics;
}

std::uint32_t crc32_of(ByteView bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace cleave::recording
