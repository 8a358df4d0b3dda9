#include "recording/mcap/recover.hpp"

#include <map>
#include <utility>

#include "recording/mcap/reader.hpp"
#include "recording/mcap/writer.hpp"

namespace cleave::recording {
namespace {

// Gives channels the ids of the new file.
class Copier {
 public:
  explicit Copier(McapWriter& out) : out_(out) {}

  void copy(const Message& message) {
    const auto [entry, is_new] = channels_.try_emplace(message.channel->id);
    if (is_new) entry->second = add(message);
    out_.write(entry->second, message.sequence, message.times, message.data);
  }

 private:
  std::uint16_t add(const Message& message) {
    const Schema& schema = *message.schema;
    const auto [entry, is_new] = schemas_.try_emplace(schema.id);
    if (is_new) entry->second = out_.add_schema(schema.name, schema.encoding, schema.text);
    const Channel& channel = *message.channel;
    return out_.add_channel(entry->second, channel.topic, channel.message_encoding,
                            channel.metadata);
  }

  McapWriter& out_;
  std::map<std::uint16_t, std::uint16_t> schemas_;
  std::map<std::uint16_t, std::uint16_t> channels_;
};

bool same_group(const Message& message, std::uint64_t log_ns, std::uint32_t sequence) {
  return message.times.log_ns == log_ns && message.sequence == sequence;
}

}  // namespace

Recovery recover(const std::filesystem::path& damaged, const std::filesystem::path& out) {
  std::error_code error;
  if (std::filesystem::equivalent(damaged, out, error)) {
    throw FileError(out.string() + ": is the damaged file itself; name another output");
  }
  McapReader reader(damaged, FindBy::scan);
  McapWriter writer(out);
  Copier copier(writer);
  std::uint64_t log_ns = 0;
  std::uint32_t sequence = 0;
  while (const auto message = reader.next()) {
    // What was written for one frame has the same time and number, and stays in one chunk.
    if (!same_group(*message, log_ns, sequence)) writer.end_group();
    log_ns = message->times.log_ns;
    sequence = message->sequence;
    copier.copy(*message);
  }
  for (const Metadata& metadata : reader.contents().metadata) writer.add_metadata(metadata);
  writer.close();
  return {writer.message_count(), reader.problems()};
}

}  // namespace cleave::recording
