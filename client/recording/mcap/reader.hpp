// SPDX-License-Identifier: BSD-3-Clause
// Reads MCAP message by message, whatever of the format its recorder used, and as far as it is
// intact.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recording/mcap/contents.hpp"
#include "recording/mcap/open_chunk.hpp"
#include "recording/mcap/sums.hpp"

namespace cleave::recording {

// Valid until the next message is asked for.
struct Message {
  const Channel* channel = nullptr;
  const Schema* schema = nullptr;  // one with the id 0 and no name where the channel has none
  std::uint32_t sequence = 0;
  MessageTimes times;
  ByteView data;
  std::uint64_t offset = 0;  // of the chunk that it is in, or before it where it is in none
};

// Messages of equal log times come in the order of the file.
enum class Order { log_time, file };

// A chunk that is damaged is passed over whole, and named in problems(); so are messages of
// channels that are nowhere described. By log time, chunks whose times overlap are held in memory
// together, up to 1 GiB: beyond, messages are only nearly in order. Deterministic.
class McapReader {
 public:
  // Throws FileError for what cannot be opened or is no MCAP.
  explicit McapReader(const std::filesystem::path& path, Order order = Order::log_time);

  // The next message whose log time is within the limits; empty at the end. Throws FileError when
  // the disk fails.
  [[nodiscard]] std::optional<Message> next();
  // Only messages of log times from `first_ns` to `last_ns`, both included, and from the
  // beginning. Chunks outside are not read.
  void limit(std::uint64_t first_ns, std::uint64_t last_ns);

  // What attachments and, after all messages were read, the file as a whole say of themselves: see
  // sums.hpp. Read every byte, and add to problems().
  void check_attachments() { recording::check_attachments(file_, contents_); }
  void check_totals(std::uint64_t messages) { recording::check_totals(file_, contents_, messages); }
  // The content of its record. Throws DataError when its CRC is wrong.
  [[nodiscard]] Bytes read(const Attachment& attachment) const {
    return read_attachment(file_, attachment);
  }

  [[nodiscard]] const Contents& contents() const { return contents_; }
  // Damage met so far, with byte offsets; contents() counts it. Empty for a file that is whole.
  [[nodiscard]] const std::vector<std::string>& problems() const {
    return contents_.problems.texts();
  }
  [[nodiscard]] std::uint64_t size_bytes() const { return file_.size(); }
  // Of the messages read so far, and of all of them where chunks are not the only place.
  [[nodiscard]] const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }
  [[nodiscard]] const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
  // The first and last log time, as chunks announce them; 0 without any message.
  [[nodiscard]] std::uint64_t start_ns() const;
  [[nodiscard]] std::uint64_t end_ns() const;

 private:
  // A chunk some of whose messages are still to be handed out.
  struct Opened {
    std::size_t number;  // in the file
    OpenChunk chunk;
    std::size_t next = 0;  // of its messages
  };
  [[nodiscard]] bool must_open() const;
  void open_next();
  void leave_message();
  void define(const OpenChunk& chunk);
  void define_before(std::size_t number);
  void note(std::size_t number, const std::string& damage);
  [[nodiscard]] std::optional<Message> message_of(const Opened& opened);
  const Channel* find_channel(std::uint16_t id, std::size_t number);
  const Schema* find_schema(const Channel& channel, std::size_t number);

  InputFile file_;
  Order order_;
  Contents contents_;
  std::uint64_t first_ns_ = 0;
  std::uint64_t last_ns_ = ~std::uint64_t{0};
  std::vector<std::size_t> sequence_;  // numbers of chunks, as they are to be opened
  std::size_t next_chunk_ = 0;         // in the sequence
  std::vector<Opened> open_;           // a heap: the one with the next message is in front
  std::size_t open_bytes_ = 0;
  bool handed_out_ = false;  // the front's next message was
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::vector<bool> defined_;              // chunks whose schemas and channels are known
  std::set<std::uint16_t> lacks_channel_;  // ids that were named in problems()
  std::set<std::uint16_t> lacks_schema_;
};

}  // namespace cleave::recording
