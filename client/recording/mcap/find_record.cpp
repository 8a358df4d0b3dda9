// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/find_record.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "recording/mcap/format.hpp"
#include "recording/mcap/io/field_source.hpp"

namespace cleave::recording {
namespace {

// The bytes that a record's fields take at least, by its opcode. Opcode 0 is none.
constexpr std::array<std::uint64_t, 16> least_bytes = {
    ~std::uint64_t{0}, 8, footer_bytes, 14, 16, 22, 40, 6, 64, 36, 48, 46, 8, 20, 17, 4};
constexpr int records_to_follow = 2;

bool is_inside_chunks(Opcode opcode) {
  return opcode == Opcode::schema || opcode == Opcode::channel || opcode == Opcode::message;
}

struct Prefix {
  Opcode opcode;
  std::uint64_t length;
};

Prefix prefix_of(ByteView bytes) {
  Prefix prefix{};
  prefix.opcode = Opcode{std::to_integer<std::uint8_t>(bytes[0])};
  std::memcpy(&prefix.length, bytes.data() + 1, sizeof prefix.length);
  return prefix;
}

bool ends_in_file(const Prefix& prefix, std::uint64_t offset, std::uint64_t file_bytes) {
  const std::uint64_t content = offset + record_prefix_bytes;
  return content <= file_bytes && prefix.length <= file_bytes - content;
}

// May a record of the format with this prefix stand at `offset`?
bool fits(const Prefix& prefix, std::uint64_t offset, std::uint64_t file_bytes) {
  const auto opcode = static_cast<std::uint8_t>(prefix.opcode);
  return opcode < least_bytes.size() && prefix.length >= least_bytes[opcode] &&
         ends_in_file(prefix, offset, file_bytes);
}

// Or one of an application?
bool may_follow(const Prefix& prefix, std::uint64_t offset, std::uint64_t file_bytes) {
  return fits(prefix, offset, file_bytes) ||
         (static_cast<std::uint8_t>(prefix.opcode) >= first_private_opcode &&
          ends_in_file(prefix, offset, file_bytes));
}

// The name of a compression is where a chunk has it: nothing else looks like that.
bool is_compressed_chunk(const InputFile& file, std::uint64_t offset, const Prefix& prefix) {
  if (prefix.opcode != Opcode::chunk) return false;
  FieldSource source(file, offset + record_prefix_bytes, prefix.length);
  source.skip(8 + 8 + 8 + 4);
  const auto name_bytes = source.number<std::uint32_t>();
  if (name_bytes != 3 && name_bytes != 4) return false;
  std::string name(name_bytes, '\0');
  if (name_bytes > source.left()) return false;
  file.read(source.offset(), std::as_writable_bytes(std::span(name)));
  return name == "zstd" || name == "lz4";
}

// Behind a record of this opcode: the file ends here, or so many records follow.
bool is_followed(const InputFile& file, Opcode last, std::uint64_t offset, int records) {
  for (; records > 0 && offset != file.size(); --records) {
    if (offset + mcap_magic.size() == file.size()) {
      return last == Opcode::footer &&
             std::ranges::equal(file.read(offset, mcap_magic.size()), bytes_of(mcap_magic));
    }
    if (offset + record_prefix_bytes > file.size()) return false;
    const Prefix prefix = prefix_of(file.read(offset, record_prefix_bytes));
    if (!may_follow(prefix, offset, file.size())) return false;
    last = prefix.opcode;
    offset += record_prefix_bytes + prefix.length;
  }
  return true;
}

bool begins(const InputFile& file, std::uint64_t offset, const Prefix& prefix) {
  if (!fits(prefix, offset, file.size())) return false;
  return is_compressed_chunk(file, offset, prefix) ||
         is_followed(file, prefix.opcode, offset + record_prefix_bytes + prefix.length,
                     records_to_follow);
}

}  // namespace

std::optional<std::uint64_t> find_record(const InputFile& file, std::uint64_t offset,
                                         Sought sought) {
  // Most records are near, and where damage is all over, there are many to look for.
  constexpr std::uint64_t smallest_window = 256;
  constexpr std::uint64_t largest_window = std::uint64_t{1} << 20U;
  std::uint64_t window = smallest_window;
  while (offset + record_prefix_bytes <= file.size()) {
    const Bytes bytes = file.read(offset, std::min(window, file.size() - offset));
    const std::size_t places = bytes.size() - record_prefix_bytes + 1;
    for (std::size_t i = 0; i < places; ++i) {
      const Prefix prefix = prefix_of(ByteView(bytes).subspan(i));
      if (sought == Sought::not_in_chunks && is_inside_chunks(prefix.opcode)) continue;
      if (begins(file, offset + i, prefix)) return offset + i;
    }
    offset += places;
    window = std::min(2 * window, largest_window);
  }
  return std::nullopt;
}

}  // namespace cleave::recording
