// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/recover.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "recording/mcap/reader.hpp"
#include "recording/mcap/writer.hpp"

namespace cleave::recording {
namespace {

class Copy {
 public:
  Copy(McapReader& from, McapWriter& to) : from_(from), to_(to) {}

  Recovery run() {
    while (const auto message = from_.next()) {
      copy_others_before(message->offset);
      copy(*message);
    }
    copy_others_before(from_.size_bytes());
    // Channels on which nothing was sent.
    for (const auto& [id, schema] : from_.schemas()) to_.declare(schema);
    for (const auto& [id, channel] : from_.channels()) declare(channel);
    to_.close();
    from_.check_totals(result_.messages);
    Problems problems = from_.contents().problems;
    problems.add(result_.problems);
    result_.problems = std::move(problems);
    return std::move(result_);
  }

 private:
  void copy(const Message& message) {
    // What was written for one frame has the same time and number, and stays in one chunk.
    const std::pair group(message.times.log_ns, message.sequence);
    if (group_ != group) to_.end_group();
    group_ = group;
    if (message.schema->id != 0) to_.declare(*message.schema);
    declare(*message.channel);
    to_.write(message.channel->id, message.sequence, message.times, message.data);
    ++result_.messages;
  }

  // A channel whose schema is lost keeps its messages, and has none.
  void declare(Channel channel) {
    if (!from_.schemas().contains(channel.schema_id)) channel.schema_id = 0;
    to_.declare(channel);
  }

  // Attachments and metadata records that lie before `offset`, in their order.
  void copy_others_before(std::uint64_t offset) {
    const auto& attachments = from_.contents().attachments;
    const auto& metadata = from_.contents().metadata;
    const auto offset_of = [](const auto& records, std::size_t next) {
      return next < records.size() ? records[next].offset : ~std::uint64_t{0};
    };
    while (true) {
      const std::uint64_t attachment = offset_of(attachments, next_attachment_);
      const std::uint64_t record = offset_of(metadata, next_metadata_);
      if (std::min(attachment, record) >= offset) return;
      if (attachment < record) {
        copy(attachments[next_attachment_++]);
      } else {
        to_.add_metadata(metadata[next_metadata_++]);
        ++result_.metadata;
      }
    }
  }

  void copy(const Attachment& attachment) {
    try {
      to_.add_attachment(attachment, from_.read(attachment));
      ++result_.attachments;
    } catch (const DataError& error) {
      result_.problems.add("attachment '" + attachment.name + "' at byte " +
                           std::to_string(attachment.offset) + ": " + error.what());
    }
  }

  McapReader& from_;
  McapWriter& to_;
  Recovery result_;
  std::optional<std::pair<std::uint64_t, std::uint32_t>> group_;
  std::size_t next_attachment_ = 0;
  std::size_t next_metadata_ = 0;
};

}  // namespace

Recovery recover(const std::filesystem::path& damaged, const std::filesystem::path& out) {
  std::error_code error;
  if (std::filesystem::equivalent(damaged, out, error)) {
    throw FileError(out.string() + ": is the damaged file itself; name another output");
  }
  McapReader reader(damaged, Order::file);
  McapWriter writer(out, McapWriter::default_chunk, reader.contents().profile);
  return Copy(reader, writer).run();
}

}  // namespace cleave::recording
