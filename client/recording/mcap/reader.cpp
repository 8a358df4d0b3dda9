// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/reader.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace cleave::recording {
namespace {

constexpr std::size_t most_open_bytes = std::size_t{1} << 30U;

// Some recorders leave the times of a chunk at zero, though it has messages.
bool tells_times(const ChunkPlace& place) {
  return place.end_ns > 0 && place.start_ns <= place.end_ns;
}

std::vector<std::size_t> sequence_of(const std::vector<ChunkPlace>& chunks, Order order) {
  std::vector<std::size_t> sequence(chunks.size());
  std::iota(sequence.begin(), sequence.end(), std::size_t{0});
  if (order == Order::log_time) {
    std::ranges::stable_sort(sequence, {}, [&](std::size_t i) {
      return tells_times(chunks[i]) ? chunks[i].start_ns : 0;
    });
  }
  return sequence;
}

// Whose next message comes later?
constexpr auto comes_later = [](const auto& a, const auto& b) {
  return std::tuple(a.chunk.messages[a.next].log_ns, a.number) >
         std::tuple(b.chunk.messages[b.next].log_ns, b.number);
};

}  // namespace

McapReader::McapReader(const std::filesystem::path& path, Order order)
    : file_(path),
      order_(order),
      contents_(read_contents(file_)),
      sequence_(sequence_of(contents_.chunks, order)),
      schemas_(contents_.schemas),
      channels_(contents_.channels),
      defined_(contents_.chunks.size()) {}

void McapReader::limit(std::uint64_t first_ns, std::uint64_t last_ns) {
  first_ns_ = first_ns;
  last_ns_ = last_ns;
  next_chunk_ = 0;
  open_.clear();
  open_bytes_ = 0;
  handed_out_ = false;
}

std::uint64_t McapReader::start_ns() const {
  std::uint64_t start_ns = end_ns();
  for (const ChunkPlace& place : contents_.chunks) {
    if (tells_times(place)) start_ns = std::min(start_ns, place.start_ns);
  }
  return start_ns;
}

std::uint64_t McapReader::end_ns() const {
  std::uint64_t end_ns = 0;
  for (const ChunkPlace& place : contents_.chunks) end_ns = std::max(end_ns, place.end_ns);
  return end_ns;
}

std::optional<Message> McapReader::next() {
  do {
    if (std::exchange(handed_out_, false)) leave_message();
    while (must_open()) open_next();
    if (open_.empty()) return std::nullopt;
    handed_out_ = true;
    if (auto message = message_of(open_.front())) return message;
  } while (true);
}

// The next message is known once all chunks are open that may have one before it.
bool McapReader::must_open() const {
  if (next_chunk_ == sequence_.size()) return false;
  if (open_.empty()) return true;
  if (order_ == Order::file || open_bytes_ >= most_open_bytes) return false;
  const ChunkPlace& place = contents_.chunks[sequence_[next_chunk_]];
  const Opened& front = open_.front();
  return !tells_times(place) || place.start_ns <= front.chunk.messages[front.next].log_ns;
}

void McapReader::open_next() {
  const std::size_t number = sequence_[next_chunk_++];
  const ChunkPlace& place = contents_.chunks[number];
  if (tells_times(place) && (place.end_ns < first_ns_ || place.start_ns > last_ns_)) return;
  Opened opened{number, {}, 0};
  try {
    opened.chunk = open_chunk(file_, place);
  } catch (const DataError& error) {
    return note(number, error.what());
  }
  if (!opened.chunk.damage.empty()) note(number, opened.chunk.damage);
  define(opened.chunk);
  defined_[number] = true;
  auto& messages = opened.chunk.messages;
  std::erase_if(messages, [this](const FoundMessage& message) {
    return message.log_ns < first_ns_ || message.log_ns > last_ns_;
  });
  if (messages.empty()) return;
  if (order_ == Order::log_time) std::ranges::stable_sort(messages, {}, &FoundMessage::log_ns);
  open_bytes_ += opened.chunk.records.view().size();
  open_.push_back(std::move(opened));
  std::ranges::push_heap(open_, comes_later);
}

// The message in front was used.
void McapReader::leave_message() {
  std::ranges::pop_heap(open_, comes_later);
  Opened& opened = open_.back();
  if (++opened.next < opened.chunk.messages.size()) {
    std::ranges::push_heap(open_, comes_later);
  } else {
    open_bytes_ -= opened.chunk.records.view().size();
    open_.pop_back();
  }
}

void McapReader::note(std::size_t number, const std::string& damage) {
  const ChunkPlace& place = contents_.chunks[number];
  contents_.problems.add((place.loose ? "messages at byte " : "chunk at byte ") +
                         std::to_string(place.offset) + ": " + damage);
}

// What was said first holds: messages handed out point to it.
void McapReader::define(const OpenChunk& chunk) {
  for (const Schema& schema : chunk.schemas) schemas_.try_emplace(schema.id, schema);
  for (const Channel& channel : chunk.channels) channels_.try_emplace(channel.id, channel);
}

// A channel is described before its first message, which may be in a chunk that is passed over, or
// opened later.
void McapReader::define_before(std::size_t number) {
  for (std::size_t i = 0; i < number; ++i) {
    if (defined_[i] || contents_.chunks[i].loose) continue;
    defined_[i] = true;
    try {
      define(open_chunk(file_, contents_.chunks[i]));
    } catch (const DataError&) {
      // Named when its messages are read.
    }
  }
}

const Channel* McapReader::find_channel(std::uint16_t id, std::size_t number) {
  if (!channels_.contains(id)) define_before(number);
  const auto found = channels_.find(id);
  if (found != channels_.end()) return &found->second;
  if (lacks_channel_.insert(id).second) {
    note(number, "messages of channel " + std::to_string(id) + ", which is nowhere described");
  }
  return nullptr;
}

const Schema* McapReader::find_schema(const Channel& channel, std::size_t number) {
  static const Schema none{};
  const std::uint16_t id = channel.schema_id;
  if (id == 0) return &none;
  if (!schemas_.contains(id)) define_before(number);
  const auto found = schemas_.find(id);
  if (found != schemas_.end()) return &found->second;
  if (lacks_schema_.insert(id).second) {
    note(number, channel.topic + ": its schema, " + std::to_string(id) + ", is not in the file");
  }
  return &none;
}

std::optional<Message> McapReader::message_of(const Opened& opened) {
  ByteSource source(opened.chunk.messages[opened.next].content);
  Message message;
  message.channel = find_channel(source.number<std::uint16_t>(), opened.number);
  if (message.channel == nullptr) return std::nullopt;
  message.schema = find_schema(*message.channel, opened.number);
  message.sequence = source.number<std::uint32_t>();
  message.times.log_ns = source.number<std::uint64_t>();
  message.times.publish_ns = source.number<std::uint64_t>();
  message.data = source.take(source.left());
  message.offset = contents_.chunks[opened.number].offset;
  return message;
}

}  // namespace cleave::recording
