// Reads MCAP message by message: complete files by their index, all others as far as they are
// intact.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "recording/mcap/contents.hpp"
#include "recording/mcap/zstd.hpp"

namespace cleave::recording {

// Valid until the next message is asked for.
struct Message {
  const Channel* channel = nullptr;
  const Schema* schema = nullptr;
  std::uint32_t sequence = 0;
  MessageTimes times;
  ByteView data;
};

// How the chunks are found.
enum class FindBy {
  index,  // and by going through the file where it has none
  scan    // by going through it anyway
};

// Messages come in the order of the file. A chunk that is damaged is passed over whole, and named
// in problems(); records that are not known are passed over. Messages outside of chunks are not
// read: no recorder of ours writes them. Deterministic.
class McapReader {
 public:
  // Throws FileError for what cannot be opened or is no MCAP.
  explicit McapReader(const std::filesystem::path& path, FindBy find = FindBy::index);

  // The next message whose log time is within the limits; empty at the end. Throws FileError when
  // the disk fails.
  [[nodiscard]] std::optional<Message> next();
  // Only messages of log times from `first_ns` to `last_ns`, both included, and from the file's
  // beginning. Chunks outside are not read.
  void limit(std::uint64_t first_ns, std::uint64_t last_ns);

  [[nodiscard]] bool indexed() const { return contents_.indexed; }
  [[nodiscard]] const Contents& contents() const { return contents_; }
  // Damage met so far, with byte offsets. Empty for a file that is whole.
  [[nodiscard]] const std::vector<std::string>& problems() const { return contents_.problems; }
  [[nodiscard]] std::uint64_t size_bytes() const { return file_.size(); }
  // The file's first and last log time; 0 without any chunk.
  [[nodiscard]] std::uint64_t start_ns() const;
  [[nodiscard]] std::uint64_t end_ns() const;

 private:
  bool open_next_chunk();
  void open_chunk(const ChunkPlace& place);
  [[nodiscard]] std::optional<Message> next_of_chunk();
  void add_schema(ByteView content);
  void add_channel(ByteView content);
  [[nodiscard]] std::optional<Message> message_of(ByteView content) const;

  InputFile file_;
  Contents contents_;
  std::uint64_t first_ns_ = 0;
  std::uint64_t last_ns_ = ~std::uint64_t{0};
  std::size_t next_chunk_ = 0;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  Block chunk_;  // the open one, whose rest is
  ByteSource rest_{ByteView{}};
};

}  // namespace cleave::recording
