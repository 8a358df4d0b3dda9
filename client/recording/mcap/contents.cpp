// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/contents.hpp"

#include <algorithm>
#include <utility>

#include "recording/mcap/find_record.hpp"
#include "recording/mcap/io/field_source.hpp"
#include "recording/mcap/sums.hpp"

namespace cleave::recording {
namespace {

// Messages outside of chunks are read together, up to so many bytes.
constexpr std::uint64_t loose_bytes = std::uint64_t{4} << 20U;

// So often as all of a file may be read again in looking for records in those that are damaged.
constexpr std::uint64_t times_read_again = 8;

void check_magic(const InputFile& file) {
  Bytes start(std::min<std::uint64_t>(mcap_magic.size(), file.size()));
  file.read(0, start);
  if (!std::ranges::equal(start, bytes_of(mcap_magic))) {
    throw FileError(file.path().string() +
                    ": is no MCAP file: it does not begin as one; `cleave record` makes them");
  }
}

struct Record {
  std::uint64_t offset;
  Opcode opcode;
  std::uint64_t length;  // of the content
  [[nodiscard]] std::uint64_t content() const { return offset + record_prefix_bytes; }
  [[nodiscard]] std::uint64_t end() const { return content() + length; }
};

class Walk {
 public:
  explicit Walk(const InputFile& file) : file_(file) {}

  Contents run() {
    while (!ended_ && offset_ < file_.size()) step();
    if (contents_.statistics) count_by_topic(*contents_.statistics);
    return std::move(contents_);
  }

 private:
  void step() {
    Record record{};
    try {
      record = record_at(offset_);
    } catch (const DataError& error) {
      return go_on_behind(error.what());
    }
    offset_ = record.end();
    try {
      resume_ = take(record);
    } catch (const DataError& error) {
      contents_.problems.add("at byte " + std::to_string(record.offset) + ": " + error.what());
      resume_ = may_read_again(record.length) ? record.offset + 1 : record.end();
    }
  }

  // A record that is none of those that it seems to be may lie about its length, too: others are
  // looked for in what it spans. Not without end, for each of these may be as long as the file.
  bool may_read_again(std::uint64_t bytes) {
    if (bytes > left_to_read_again_) return false;
    left_to_read_again_ -= bytes;
    return true;
  }

  void go_on_behind(const std::string& damage) {
    const Sought sought = has_chunks_ ? Sought::not_in_chunks : Sought::any;
    const std::uint64_t next = find_record(file_, resume_, sought).value_or(file_.size());
    contents_.problems.add(
        "at byte " + std::to_string(offset_) + ": " + damage +
        (next < file_.size() ? "; reading goes on at byte " + std::to_string(next) : ""));
    offset_ = next;
  }

  [[nodiscard]] Record record_at(std::uint64_t offset) const {
    FieldSource source(file_, offset, file_.size() - offset);
    if (source.left() < record_prefix_bytes) throw DataError("the file ends within a record");
    const auto opcode = source.number<Opcode>();
    const auto length = source.number<std::uint64_t>();
    if (opcode == Opcode{0}) throw DataError("no record begins here");
    if (length > source.left()) throw DataError("the file ends within a record");
    return {offset, opcode, length};
  }

  // Takes note of the record. Returns where it surely ends, at the latest.
  std::uint64_t take(const Record& record) {
    switch (record.opcode) {
      case Opcode::header:
        contents_.profile = fields(record).string();
        break;
      case Opcode::footer:
        take_footer(record);
        break;
      case Opcode::schema:
        add(contents_.schemas, decode_schema(content(record)));
        break;
      case Opcode::channel:
        add(contents_.channels, decode_channel(content(record)));
        break;
      case Opcode::message:
        take_message(record);
        break;
      case Opcode::chunk:
        return take_chunk(record);
      case Opcode::attachment:
        take_attachment(record);
        break;
      case Opcode::metadata:
        contents_.metadata.push_back(decode_metadata(content(record)));
        contents_.metadata.back().offset = record.offset;
        break;
      case Opcode::statistics:
        contents_.statistics = decode_statistics(content(record));
        break;
      case Opcode::data_end:
        contents_.data_crc = fields(record).number<std::uint32_t>();
        contents_.data_end = record.offset;
        break;
      case Opcode::message_index:
      case Opcode::chunk_index:
      case Opcode::attachment_index:
      case Opcode::metadata_index:
      case Opcode::summary_offset:
        break;
      default:
        ++(static_cast<std::uint8_t>(record.opcode) >= first_private_opcode
               ? contents_.private_records
               : contents_.unknown_records);
    }
    return record.end();
  }

  // What was said first holds: the summary repeats it.
  template <class Definition>
  static void add(std::map<std::uint16_t, Definition>& definitions, Definition definition) {
    const std::uint16_t id = definition.id;
    definitions.try_emplace(id, std::move(definition));
  }

  void take_message(const Record& record) {
    FieldSource source = fields(record);
    source.skip(2 + 4);  // channel and number
    const auto log_ns = source.number<std::uint64_t>();
    source.skip(8);
    const std::uint64_t bytes = record.end() - record.offset;
    auto& chunks = contents_.chunks;
    if (!chunks.empty() && chunks.back().loose &&
        chunks.back().offset + chunks.back().length == record.offset &&
        chunks.back().length + bytes <= loose_bytes) {
      ChunkPlace& run = chunks.back();
      run.length += bytes;
      run.start_ns = std::min(run.start_ns, log_ns);
      run.end_ns = std::max(run.end_ns, log_ns);
    } else {
      chunks.push_back({record.offset, bytes, log_ns, log_ns, true});
    }
  }

  std::uint64_t take_chunk(const Record& record) {
    FieldSource source = fields(record);
    const auto start_ns = source.number<std::uint64_t>();
    const auto end_ns = source.number<std::uint64_t>();
    source.skip(8 + 4);  // size and CRC
    source.skip(source.number<std::uint32_t>());
    source.skip(source.number<std::uint64_t>());
    contents_.chunks.push_back(
        {record.offset, source.offset() - record.offset, start_ns, end_ns, false});
    has_chunks_ = true;
    return source.offset();
  }

  void take_attachment(const Record& record) {
    FieldSource source = fields(record);
    Attachment attachment;
    attachment.log_ns = source.number<std::uint64_t>();
    attachment.create_ns = source.number<std::uint64_t>();
    attachment.name = source.string();
    attachment.media_type = source.string();
    attachment.data_bytes = source.number<std::uint64_t>();
    source.skip(attachment.data_bytes);
    source.skip(sizeof(std::uint32_t));
    attachment.offset = record.offset;
    attachment.length = source.offset() - record.content();
    contents_.attachments.push_back(std::move(attachment));
  }

  void take_footer(const Record& record) {
    FieldSource source = fields(record);
    const auto summary = source.number<std::uint64_t>();
    source.skip(sizeof(std::uint64_t));
    const std::uint64_t summed = source.offset();
    const auto crc = source.number<std::uint32_t>();
    take_end(record.end());
    const std::uint64_t begin = summary == 0 ? record.offset : summary;
    if (begin > record.offset || (crc != 0 && crc32_of(file_, begin, summed) != crc)) {
      contents_.statistics.reset();
      throw DataError("the summary at its end is damaged: its place or its CRC is wrong");
    }
  }

  void take_end(std::uint64_t offset) {
    const std::uint64_t left = file_.size() - offset;
    const Bytes end = file_.read(offset, std::min<std::uint64_t>(left, mcap_magic.size()));
    if (!std::ranges::equal(end, bytes_of(mcap_magic.substr(0, end.size())))) {
      throw DataError("a footer, and not the file's end");
    }
    ended_ = true;
    contents_.closed = left >= mcap_magic.size();
    if (!contents_.closed) throw DataError("the file ends within its last 8 bytes");
    if (left > mcap_magic.size()) {
      contents_.problems.add("at byte " + std::to_string(offset + mcap_magic.size()) +
                             ": the recording ends, and something else follows");
    }
  }

  void count_by_topic(const Statistics& statistics) {
    for (const auto& [id, count] : statistics.message_counts) {
      const auto channel = contents_.channels.find(id);
      if (channel != contents_.channels.end()) {
        contents_.message_counts[channel->second.topic] += count;
      }
    }
  }

  [[nodiscard]] FieldSource fields(const Record& record) const {
    return {file_, record.content(), record.length};
  }
  [[nodiscard]] Bytes content(const Record& record) const {
    return file_.read(record.content(), record.length);
  }

  const InputFile& file_;
  Contents contents_;
  std::uint64_t offset_ = mcap_magic.size();  // of the next record
  std::uint64_t resume_ = mcap_magic.size();  // from where one is looked for if none is there
  std::uint64_t left_to_read_again_ = times_read_again * file_.size();
  bool has_chunks_ = false;
  bool ended_ = false;
};

}  // namespace

Contents read_contents(const InputFile& file) {
  check_magic(file);
  return Walk(file).run();
}

}  // namespace cleave::recording
