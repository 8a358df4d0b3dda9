// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/record_walk.hpp"

#include <algorithm>
#include <array>

#include "recording/mcap/bytes.hpp"

namespace cleave::oni {
namespace {

using recording::ByteSource;

constexpr std::array<std::uint8_t, 4> magic = {'N', 'I', 'R', 0};
constexpr std::size_t search_block = std::size_t{1} << 16;

// The numbers have no gaps; 1 was never used.
bool is_known(std::uint32_t type) {
  return type >= static_cast<std::uint32_t>(RecordType::node_added_1_0_0_4) &&
         type <= static_cast<std::uint32_t>(RecordType::seek_table);
}

}  // namespace

RecordWalk::RecordWalk(const File& file, std::uint64_t first, bool wide)
    : file_(file), position_(first), search_from_(first), header_bytes_(wide ? 28 : 24) {}

std::optional<Record> RecordWalk::next() {
  bool skipped = false;
  while (!ended_ && position_ < file_.size()) {
    if (const std::optional<Record> record = record_at(position_)) {
      damaged_ = damaged_ || skipped;
      search_from_ = position_ + magic.size();
      position_ = record->payload + record->payload_bytes;
      ended_ = record->type == RecordType::end;
      return record;
    }
    skipped = true;
    position_ = find_magic(search_from_).value_or(file_.size());
    search_from_ = position_ + magic.size();
  }
  return std::nullopt;
}

std::optional<Record> RecordWalk::record_at(std::uint64_t position) {
  ByteSource bytes(std::as_bytes(file_.read(position, header_bytes_, header_)));
  const auto start = bytes.try_take(magic.size());
  if (!start || !std::ranges::equal(*start, std::as_bytes(std::span(magic)))) return std::nullopt;
  const auto type = bytes.try_number<std::uint32_t>();
  const auto node = bytes.try_number<std::uint32_t>();
  const auto header_and_fields = bytes.try_number<std::uint32_t>();
  const auto payload = bytes.try_number<std::uint32_t>();
  if (!payload || !is_known(*type) || *header_and_fields < header_bytes_) return std::nullopt;
  const Record record{static_cast<RecordType>(*type), *node,
                      position + header_bytes_,       *header_and_fields - header_bytes_,
                      position + *header_and_fields,  *payload};
  if (record.payload + record.payload_bytes > file_.size()) return std::nullopt;
  return record;
}

std::optional<std::uint64_t> RecordWalk::find_magic(std::uint64_t from) {
  while (from < file_.size()) {
    if (from < block_position_ || from >= block_position_ + block_.size()) {
      block_ = file_.read(from, search_block, block_buffer_);
      block_position_ = from;
      if (block_.empty()) return std::nullopt;
    }
    const auto rest = block_.subspan(static_cast<std::size_t>(from - block_position_));
    const auto found = std::search(rest.begin(), rest.end(), magic.begin(), magic.end());
    if (found != rest.end()) return from + static_cast<std::uint64_t>(found - rest.begin());
    // The last bytes again, with the next block: a magic may lie across the two.
    if (block_position_ + block_.size() >= file_.size()) return std::nullopt;
    from = std::max(from + 1, block_position_ + block_.size() - (magic.size() - 1));
    block_ = {};
  }
  return std::nullopt;
}

}  // namespace cleave::oni
