// What a file holds and where: from its index, or else by going through it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "recording/mcap/format.hpp"
#include "recording/mcap/input_file.hpp"

namespace cleave::recording {

struct Contents {
  bool indexed = false;            // the file is complete: its index was read
  std::vector<ChunkPlace> chunks;  // in the order of the file
  std::vector<Metadata> metadata;
  std::map<std::string, std::uint64_t> message_counts;  // by topic; only of an indexed file
  std::vector<std::string> problems;                    // damage that was met, with its offset
};

// Reads the summary if it is there and its CRC is right; else walks through the records, and behind
// damage goes on at the next thing that looks like a chunk. Never reads a chunk's data.
// Throws FileError for a file that is no MCAP at all.
[[nodiscard]] Contents read_contents(const InputFile& file);

// The same without a look at the index.
[[nodiscard]] Contents scan_contents(const InputFile& file);

}  // namespace cleave::recording
