// Going through a file whose end is missing or not to be trusted.
#include <algorithm>
#include <array>
#include <optional>

#include "recording/mcap/contents.hpp"

namespace cleave::recording {
namespace {

constexpr std::uint64_t data_offset = mcap_magic.size();
// Of a chunk's content, up to its data: times, size, CRC, "zstd" and its length, compressed size.
constexpr std::size_t chunk_times_bytes = 16;
constexpr std::size_t before_compression = 8 + 8 + 8 + 4;
constexpr std::array<char, 8> zstd_text = {4, 0, 0, 0, 'z', 's', 't', 'd'};

bool is_known(Opcode opcode) {
  return opcode >= Opcode::header && opcode <= Opcode::data_end;
}

// Where the next thing begins, from `offset` on, that has the name of a compression in the place
// where a chunk has it.
std::optional<std::uint64_t> find_chunk(const InputFile& file, std::uint64_t offset) {
  constexpr std::uint64_t name_offset = record_prefix_bytes + before_compression;
  constexpr std::uint64_t window = std::uint64_t{1} << 20U;
  const ByteView name = std::as_bytes(std::span(zstd_text));
  for (std::uint64_t at = offset + name_offset; at + name.size() <= file.size();
       at += window - name.size()) {
    const Bytes bytes = file.read(at, std::min(window, file.size() - at));
    const auto found = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
    if (found == bytes.end()) continue;
    return at + static_cast<std::uint64_t>(found - bytes.begin()) - name_offset;
  }
  return std::nullopt;
}

class Scan {
 public:
  explicit Scan(const InputFile& file) : file_(file) {}

  Contents run() {
    std::uint64_t offset = data_offset;
    bool ended = false;
    while (!ended && offset < file_.size()) {
      try {
        offset = record_at(offset, ended);
      } catch (const DataError& error) {
        contents_.problems.push_back("at byte " + std::to_string(offset) + ": " + error.what());
        const auto next = find_chunk(file_, offset + 1);
        if (!next) break;
        offset = *next;
      }
    }
    return std::move(contents_);
  }

 private:
  // Takes note of the record; returns where the next one begins.
  std::uint64_t record_at(std::uint64_t offset, bool& ended) {
    const Bytes prefix = file_.read(offset, record_prefix_bytes);
    ByteSource source(prefix);
    const auto opcode = source.number<Opcode>();
    const auto length = source.number<std::uint64_t>();
    const std::uint64_t content = offset + record_prefix_bytes;
    if (!is_known(opcode)) throw DataError("no record begins here");
    if (length > file_.size() - content) throw DataError("the file ends within a record");
    if (opcode == Opcode::chunk) {
      note_chunk(offset, length);
    } else if (opcode == Opcode::metadata) {
      contents_.metadata.push_back(decode_metadata(file_.read(content, length)));
    }
    ended = opcode == Opcode::data_end;
    return content + length;
  }

  void note_chunk(std::uint64_t offset, std::uint64_t length) {
    const Bytes times = file_.read(offset + record_prefix_bytes, chunk_times_bytes);
    ByteSource source(times);
    const auto start_ns = source.number<std::uint64_t>();
    const auto end_ns = source.number<std::uint64_t>();
    contents_.chunks.push_back({offset, record_prefix_bytes + length, start_ns, end_ns});
  }

  const InputFile& file_;
  Contents contents_;
};

}  // namespace

Contents scan_contents(const InputFile& file) {
  return Scan(file).run();
}

}  // namespace cleave::recording
