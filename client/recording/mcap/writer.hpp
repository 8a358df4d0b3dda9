// SPDX-License-Identifier: BSD-3-Clause
// Writes MCAP: zstd chunks with their CRCs and message indexes, attachments and metadata, and at
// the end a summary with schemas, channels, statistics and the indexes of all these.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/mcap/compression/zstd.hpp"
#include "recording/mcap/format.hpp"
#include "recording/mcap/io/output_file.hpp"

namespace cleave::recording {

// A file that is cut off loses the chunk that was being filled and nothing else: every chunk holds
// the schemas and channels of its messages, and goes to the file whole. One thread at a time.
class McapWriter {
 public:
  // Creates the file. `chunk_bytes`: a chunk is closed at the end of the group that makes it
  // larger. `profile`: what readers may expect of all schemas, e.g. "ros2". Throws FileError.
  explicit McapWriter(const std::filesystem::path& path, std::size_t chunk_bytes = default_chunk,
                      std::string_view profile = "");

  // The schema's id.
  [[nodiscard]] std::uint16_t add_schema(std::string name, std::string encoding, std::string text);
  // The channel's id.
  [[nodiscard]] std::uint16_t add_channel(std::uint16_t schema_id, std::string topic,
                                          std::string message_encoding, Texts metadata = {});
  // With the ids that they have, as those of another file; what is there stays.
  void declare(const Schema& schema) { schemas_.try_emplace(schema.id, schema); }
  void declare(const Channel& channel) { channels_.try_emplace(channel.id, channel); }

  // `data` is copied. No file access happens here.
  void write(std::uint16_t channel_id, std::uint32_t sequence, const MessageTimes& times,
             ByteView data);
  // The messages written since the last call belong together: they are never torn apart by the loss
  // of a chunk. Throws FileError, and then the messages of the chunk are lost.
  void end_group();
  // Closes the chunk, if it holds any message. Throws FileError.
  void flush();
  void add_metadata(const Metadata& metadata);
  // `content`: of the attachment's record in another file, times, names and CRC included.
  void add_attachment(const Attachment& attachment, ByteView content);
  // Flushes, writes the summary and the end. Nothing may be written after. Throws FileError.
  void close();

  // In the file and in the open chunk.
  [[nodiscard]] std::uint64_t size_bytes() const { return file_.size() + chunk_.size(); }
  [[nodiscard]] std::uint64_t message_count() const { return message_count_; }

  static constexpr std::size_t default_chunk = std::size_t{4} << 20U;

 private:
  struct IndexEntry {
    std::uint64_t log_ns;
    std::uint64_t offset;  // in the chunk
  };
  struct WrittenChunk {
    ChunkPlace place;
    std::map<std::uint16_t, std::uint64_t> index_offsets;
    std::uint64_t index_bytes = 0;
    std::uint64_t compressed_bytes = 0;
    std::uint64_t plain_bytes = 0;
    std::map<std::uint16_t, std::uint64_t> message_counts;
  };
  struct RecordPlace {
    std::uint64_t offset;
    std::uint64_t length;
  };
  void introduce(std::uint16_t channel_id);
  void write_chunk();
  void start_chunk();
  [[nodiscard]] RecordPlace put(Opcode opcode, ByteView content);
  [[nodiscard]] Bytes chunk_indexes(std::uint64_t offset, WrittenChunk& written) const;
  [[nodiscard]] Statistics statistics() const;
  [[nodiscard]] Bytes chunk_index_records() const;
  [[nodiscard]] Bytes attachment_index_records() const;
  [[nodiscard]] Bytes metadata_index_records() const;
  [[nodiscard]] Bytes summary_section(std::uint64_t offset) const;

  OutputFile file_;
  std::size_t chunk_bytes_;
  ZstdCompressor compressor_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;

  Bytes chunk_;
  std::set<std::uint16_t> introduced_;  // channels whose records the open chunk holds
  std::map<std::uint16_t, std::vector<IndexEntry>> index_;  // of the open chunk
  std::uint64_t chunk_start_ns_ = 0;
  std::uint64_t chunk_end_ns_ = 0;

  std::vector<WrittenChunk> written_;
  std::vector<std::pair<RecordPlace, std::string>> metadata_;  // and its name
  std::vector<std::pair<RecordPlace, Attachment>> attachments_;
  std::uint64_t message_count_ = 0;
};

}  // namespace cleave::recording
