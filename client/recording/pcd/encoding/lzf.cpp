// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/encoding/lzf.hpp"

#include <algorithm>
#include <array>

namespace cleave::recording {
namespace {

constexpr std::size_t shortest_match = 3;
constexpr std::size_t longest_match = 264;
constexpr std::size_t farthest_match = 8192;  // bytes back
constexpr std::size_t longest_literal = 32;
constexpr unsigned hash_bits = 14;

// Of the three bytes at `p`.
std::size_t hash_of(const std::uint8_t* p) {
  const std::uint32_t bytes = p[0] | std::uint32_t{p[1]} << 8U | std::uint32_t{p[2]} << 16U;
  return bytes * 2654435761U >> (32U - hash_bits);
}

void put_literals(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& block) {
  while (!bytes.empty()) {
    const auto run = bytes.first(std::min(bytes.size(), longest_literal));
    block.push_back(static_cast<std::uint8_t>(run.size() - 1));
    block.insert(block.end(), run.begin(), run.end());
    bytes = bytes.subspan(run.size());
  }
}

// 3 bits of length and 13 of distance; a length that needs more has a byte in between.
void put_match(std::size_t length, std::size_t distance, std::vector<std::uint8_t>& block) {
  constexpr std::size_t short_lengths = 7;
  const std::size_t far = distance - 1;
  const std::size_t more = length - 2;
  const auto put = [&](std::size_t byte) { block.push_back(static_cast<std::uint8_t>(byte)); };
  put(std::min(more, short_lengths) << 5U | far >> 8U);
  if (more >= short_lengths) put(more - short_lengths);
  put(far & 0xFFU);
}

}  // namespace

std::vector<std::uint8_t> lzf_compressed(std::span<const std::uint8_t> plain) {
  std::vector<std::uint8_t> block;
  block.reserve(plain.size());
  std::vector<std::size_t> latest(std::size_t{1} << hash_bits, 0);  // position + 1; 0 = none
  std::size_t written = 0;
  for (std::size_t at = 0; at + shortest_match <= plain.size();) {
    std::size_t& slot = latest[hash_of(&plain[at])];
    const std::size_t candidate = slot;
    slot = at + 1;
    const std::size_t distance = candidate == 0 ? 0 : at + 1 - candidate;
    std::size_t length = 0;
    if (distance > 0 && distance <= farthest_match) {
      const std::size_t most = std::min(longest_match, plain.size() - at);
      while (length < most && plain[at + length] == plain[at + length - distance]) ++length;
    }
    if (length < shortest_match) {
      ++at;
      continue;
    }
    put_literals(plain.subspan(written, at - written), block);
    put_match(length, distance, block);
    written = at += length;
    if (block.size() >= plain.size()) return {};
  }
  put_literals(plain.subspan(written), block);
  return block.size() < plain.size() ? block : std::vector<std::uint8_t>{};
}

}  // namespace cleave::recording
