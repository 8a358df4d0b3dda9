// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "recording/pcd/encoding/body.hpp"
#include "recording/pcd/encoding/number.hpp"

namespace cleave::recording {
namespace {

std::size_t numbers_of(const PcdHeader& header) {
  std::size_t numbers = 0;
  for (const PcdField& field : header.fields) numbers += field.count;
  return numbers;
}

bool is_blank(std::string_view line) {
  return take_word(line).empty();
}

// Reads points from lines, one a line.
class AsciiPoints {
 public:
  AsciiPoints(PcdInput& input, const PcdHeader& header)
      : input_(input), header_(header), numbers_(numbers_of(header)) {}

  // The bytes of a point to `to`, which is then behind them. False: the file ends within the line.
  [[nodiscard]] bool read(std::string_view line, std::uint8_t* to) {
    std::string_view rest = line;
    std::size_t found = 0;
    for (const PcdField& field : header_.fields) {
      for (std::uint32_t i = 0; i < field.count; ++i, ++found) {
        const std::string_view word = take_word(rest);
        if (word.empty()) return refuse_count(found);
        if (field.is_padding()) continue;
        if (const char* const problem = write_number(word, field, to)) {
          refuse_word(word, field, problem);
        }
        to += field.size;
      }
    }
    if (!is_blank(rest)) {
      while (!take_word(rest).empty()) ++found;
      return refuse_count(found);
    }
    return true;
  }

 private:
  // Of the file's last line there may be a part only.
  bool refuse_count(std::size_t found) {
    if (found < numbers_ && input_.bytes_left() == 0) return false;
    input_.refuse_line(PcdCause::damaged_data,
                       "has " + std::to_string(found) + " numbers, the fields of a point ask for " +
                           std::to_string(numbers_) + "; correct the line or the header");
  }
  [[noreturn]] void refuse_word(std::string_view word, const PcdField& field,
                                const char* problem) const {
    constexpr std::size_t longest_quote = 40;
    input_.refuse_line(PcdCause::damaged_data,
                       "'" + std::string(word.substr(0, longest_quote)) + "' in field " +
                           field.name + " (TYPE " + field.type + ", SIZE " +
                           std::to_string(field.size) + ") " + problem + "; correct it");
  }

  PcdInput& input_;
  const PcdHeader& header_;
  std::size_t numbers_;
};

}  // namespace

std::vector<std::uint8_t> read_ascii(PcdInput& input, const PcdHeader& header) {
  PcdHeader stored = header;
  stored.fields = without_padding(header.fields);
  const std::size_t step = stored.point_bytes();
  // A number takes two characters at least: a digit, and what keeps it from the next.
  const std::uint64_t most = input.bytes_left() / (2 * numbers_of(header)) + 1;
  std::vector<std::uint8_t> data;
  data.reserve(static_cast<std::size_t>(std::min(header.points(), most)) * step);
  AsciiPoints points(input, header);
  std::string_view line;
  for (std::uint64_t found = 0; found < header.points();) {
    if (!input.next_line(line)) refuse_truncated(input, header, found);
    if (is_blank(line)) continue;
    data.resize(data.size() + step);
    if (!points.read(line, data.data() + data.size() - step)) {
      refuse_truncated(input, header, found);
    }
    ++found;
  }
  return data;
}

}  // namespace cleave::recording
