#include "recording/mcap/reader.hpp"

#include <algorithm>
#include <utility>

namespace cleave::recording {
namespace {

// Far beyond what recorders make; a size that lies must not cost more memory than that.
constexpr std::uint64_t largest_chunk = std::uint64_t{256} << 20U;

// Throws DataError.
Block unpack(const std::string& compression, ByteView data, std::uint64_t plain_bytes) {
  if (compression == "zstd") return zstd_decompress(data, static_cast<std::size_t>(plain_bytes));
  if (!compression.empty()) {
    throw DataError("its compression '" + compression +
                    "' is not read; convert the file to zstd, e.g. with `mcap compress`");
  }
  Block block(data.size());
  std::ranges::copy(data, block.bytes().begin());
  return block;
}

// The chunk's records, with their CRC checked. Throws DataError.
Block plain_records(ByteView content) {
  ByteSource source(content);
  (void)source.take(2 * sizeof(std::uint64_t));  // the times
  const auto plain_bytes = source.number<std::uint64_t>();
  const auto crc = source.number<std::uint32_t>();
  const std::string compression = source.string();
  const ByteView data = source.take(source.number<std::uint64_t>());
  if (plain_bytes > largest_chunk) {
    throw DataError("it announces " + std::to_string(plain_bytes) +
                    " bytes, more than a chunk has");
  }
  Block block = unpack(compression, data, plain_bytes);
  if (crc != 0 && crc32_of(block.view()) != crc) throw DataError("its CRC is wrong");
  return block;
}

}  // namespace

McapReader::McapReader(const std::filesystem::path& path, FindBy find)
    : file_(path), contents_(find == FindBy::index ? read_contents(file_) : scan_contents(file_)) {}

void McapReader::limit(std::uint64_t first_ns, std::uint64_t last_ns) {
  first_ns_ = first_ns;
  last_ns_ = last_ns;
  next_chunk_ = 0;
  rest_ = ByteSource(ByteView{});
}

std::uint64_t McapReader::start_ns() const {
  const auto& chunks = contents_.chunks;
  return chunks.empty() ? 0 : std::ranges::min(chunks, {}, &ChunkPlace::start_ns).start_ns;
}

std::uint64_t McapReader::end_ns() const {
  const auto& chunks = contents_.chunks;
  return chunks.empty() ? 0 : std::ranges::max(chunks, {}, &ChunkPlace::end_ns).end_ns;
}

std::optional<Message> McapReader::next() {
  do {
    while (auto message = next_of_chunk()) {
      const std::uint64_t time_ns = message->times.log_ns;
      if (time_ns >= first_ns_ && time_ns <= last_ns_) return message;
    }
  } while (open_next_chunk());
  return std::nullopt;
}

// False when there is none.
bool McapReader::open_next_chunk() {
  while (next_chunk_ < contents_.chunks.size()) {
    const ChunkPlace& place = contents_.chunks[next_chunk_++];
    if (place.end_ns < first_ns_ || place.start_ns > last_ns_) continue;
    try {
      open_chunk(place);
      return true;
    } catch (const DataError& error) {
      contents_.problems.push_back("chunk at byte " + std::to_string(place.offset) + ": " +
                                   error.what());
    }
  }
  return false;
}

void McapReader::open_chunk(const ChunkPlace& place) {
  const Bytes record = file_.read(place.offset, place.length);
  ByteSource source(record);
  if (source.number<Opcode>() != Opcode::chunk) throw DataError("no chunk begins here");
  chunk_ = plain_records(source.take(source.number<std::uint64_t>()));
  rest_ = ByteSource(chunk_.view());
}

std::optional<Message> McapReader::next_of_chunk() {
  try {
    while (rest_.left() > 0) {
      const auto opcode = rest_.number<Opcode>();
      const ByteView content = rest_.take(rest_.number<std::uint64_t>());
      if (opcode == Opcode::schema) {
        add_schema(content);
      } else if (opcode == Opcode::channel) {
        add_channel(content);
      } else if (opcode == Opcode::message) {
        if (auto message = message_of(content)) return message;
      }
    }
  } catch (const DataError& error) {
    rest_ = ByteSource(ByteView{});
    contents_.problems.push_back(std::string("a chunk's records: ") + error.what());
  }
  return std::nullopt;
}

// What was said first holds: messages handed out point to it.
void McapReader::add_schema(ByteView content) {
  Schema schema = decode_schema(content);
  schemas_.try_emplace(schema.id, std::move(schema));
}

void McapReader::add_channel(ByteView content) {
  Channel channel = decode_channel(content);
  channels_.try_emplace(channel.id, std::move(channel));
}

std::optional<Message> McapReader::message_of(ByteView content) const {
  ByteSource source(content);
  const auto channel = channels_.find(source.number<std::uint16_t>());
  if (channel == channels_.end()) throw DataError("a message is of a channel that is not there");
  const auto schema = schemas_.find(channel->second.schema_id);
  if (schema == schemas_.end()) return std::nullopt;  // of no schema: nothing of ours
  Message message{&channel->second, &schema->second, 0, {}, {}};
  message.sequence = source.number<std::uint32_t>();
  message.times.log_ns = source.number<std::uint64_t>();
  message.times.publish_ns = source.number<std::uint64_t>();
  message.data = source.take(source.left());
  return message;
}

}  // namespace cleave::recording
