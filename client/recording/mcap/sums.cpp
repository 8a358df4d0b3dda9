// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/sums.hpp"

#include <algorithm>
#include <string>

#include "recording/mcap/io/field_source.hpp"

namespace cleave::recording {
namespace {

// Of an attachment's record, without the CRC that is its last field.
struct Extent {
  std::uint64_t begin;
  std::uint64_t end;
};

Extent summed_part(const Attachment& attachment) {
  const std::uint64_t begin = attachment.offset + record_prefix_bytes;
  return {begin, begin + attachment.length - sizeof(std::uint32_t)};
}

void check(std::uint32_t announced, std::uint32_t found) {
  if (announced != 0 && announced != found) throw DataError("its CRC is wrong");
}

void compare(Contents& contents, const char* what, std::uint64_t announced, std::uint64_t found) {
  if (announced == found) return;
  contents.problems.add("its statistics announce " + std::to_string(announced) + " " + what +
                        ", and " + std::to_string(found) + " are there");
}

}  // namespace

std::uint32_t crc32_of(const InputFile& file, std::uint64_t begin, std::uint64_t end) {
  constexpr std::uint64_t window = std::uint64_t{1} << 20U;
  std::uint32_t crc = 0;
  for (; begin < end; begin += std::min(window, end - begin)) {
    crc = crc32_of(file.read(begin, std::min(window, end - begin)), crc);
  }
  return crc;
}

Bytes read_attachment(const InputFile& file, const Attachment& attachment) {
  Bytes content = file.read(attachment.offset + record_prefix_bytes, attachment.length);
  ByteSource source(content);
  const std::uint32_t found = crc32_of(source.take(content.size() - sizeof(std::uint32_t)));
  check(source.number<std::uint32_t>(), found);
  return content;
}

void check_attachments(const InputFile& file, Contents& contents) {
  for (const Attachment& attachment : contents.attachments) {
    const Extent part = summed_part(attachment);
    try {
      check(FieldSource(file, part.end, sizeof(std::uint32_t)).number<std::uint32_t>(),
            crc32_of(file, part.begin, part.end));
    } catch (const DataError& error) {
      contents.problems.add("attachment '" + attachment.name + "' at byte " +
                            std::to_string(attachment.offset) + ": " + error.what());
    }
  }
}

void check_totals(const InputFile& file, Contents& contents, std::uint64_t messages) {
  if (!contents.problems.empty()) return;
  if (contents.data_crc != 0 && crc32_of(file, 0, contents.data_end) != contents.data_crc) {
    contents.problems.add(
        "the CRC of all its data is wrong: something is changed that no other CRC is of");
  }
  if (!contents.statistics) return;
  const Statistics& announced = *contents.statistics;
  compare(contents, "messages", announced.messages, messages);
  compare(contents, "attachments", announced.attachments, contents.attachments.size());
  compare(contents, "metadata records", announced.metadata, contents.metadata.size());
}

}  // namespace cleave::recording
