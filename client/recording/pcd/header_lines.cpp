// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/header_lines.hpp"

#include <algorithm>
#include <array>

namespace cleave::recording {
namespace {

constexpr std::size_t longest_header_bytes = std::size_t{64} * 1024;

constexpr std::array<std::string_view, 10> keywords = {
    "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

bool is_printable(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c > ' ' && c <= '~'; });
}

[[noreturn]] void refuse_keyword(const PcdInput& input, std::string_view word, bool is_first) {
  constexpr std::size_t longest_quote = 40;
  const std::string quoted = word.size() <= longest_quote && is_printable(word)
                                 ? "'" + std::string(word) + "', which is"
                                 : "what is";
  input.refuse_line(is_first ? PcdCause::not_pcd : PcdCause::bad_header,
                    (is_first ? "is no PCD file: it begins with " : "the header has ") + quoted +
                        " none of PCD's words; name a PCD file, or correct the line");
}

}  // namespace

HeaderLines read_header_lines(PcdInput& input) {
  HeaderLines lines;
  std::size_t bytes = 0;
  std::string_view line;
  while (bytes < longest_header_bytes && input.next_line(line)) {
    bytes += line.size() + 1;
    std::string_view keyword = take_word(line);
    if (keyword.empty() || keyword.front() == '#') continue;
    if (keyword == "COLUMNS") keyword = "FIELDS";
    // A reader that guesses here would read the points from anywhere.
    if (std::ranges::find(keywords, keyword) == keywords.end()) {
      refuse_keyword(input, keyword, lines.empty());
    }
    const auto [entry, is_new] = lines.try_emplace(std::string(keyword));
    if (!is_new) {
      input.refuse_line(PcdCause::bad_header,
                        "the header has two lines " + entry->first + "; remove one of them");
    }
    for (std::string_view word; !(word = take_word(line)).empty();)
      entry->second.emplace_back(word);
    if (keyword == "DATA") return lines;
  }
  if (lines.empty()) {
    input.refuse(PcdCause::not_pcd, "is no PCD file: it has no header; name a PCD file");
  }
  input.refuse(PcdCause::truncated,
               "is cut off in its header: there is no line DATA in its first 64 kB; copy or record "
               "it again");
}

}  // namespace cleave::recording
