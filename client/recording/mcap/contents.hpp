// SPDX-License-Identifier: BSD-3-Clause
// What a file holds and where, found by going through its records from the first to the last.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "recording/mcap/format.hpp"
#include "recording/mcap/io/input_file.hpp"
#include "recording/problems.hpp"

namespace cleave::recording {

struct Contents {
  bool closed = false;             // the file ends as its recorder ends one, and nothing is cut off
  std::string profile;             // "ros2", or empty
  std::vector<ChunkPlace> chunks;  // all that holds messages, in the order of the file
  std::vector<Attachment> attachments;
  std::vector<Metadata> metadata;
  // Those outside of chunks, be it before their messages or in the summary at the end.
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  // Of the summary, unless it is damaged.
  std::optional<Statistics> statistics;
  std::map<std::string, std::uint64_t> message_counts;  // by topic, as the statistics have it
  // Where the data ends, and the CRC of all before; 0 = there is none.
  std::uint64_t data_end = 0;
  std::uint32_t data_crc = 0;
  // Records that are passed over: of applications, and of opcodes that the format does not have.
  std::uint64_t private_records = 0;
  std::uint64_t unknown_records = 0;
  Problems problems;  // damage that was met, with its offset
};

// No index is asked: it need not be there, or list everything. The data of chunks, messages and
// attachments is not read. Behind damage it goes on at the next thing that looks like a record.
// Throws FileError for a file that is no MCAP at all.
[[nodiscard]] Contents read_contents(const InputFile& file);

}  // namespace cleave::recording
