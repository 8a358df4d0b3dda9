// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/header.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "recording/pcd/header_lines.hpp"

namespace cleave::recording {
namespace {

constexpr std::size_t largest_point_bytes = std::size_t{64} * 1024;

using Words = std::vector<std::string>;

[[noreturn]] void refuse(const PcdInput& input, const std::string& why) {
  input.refuse(PcdCause::bad_header, why);
}

const Words* find_line(const HeaderLines& lines, std::string_view key) {
  const auto found = lines.find(key);
  return found == lines.end() || found->second.empty() ? nullptr : &found->second;
}

const Words& line_of(const HeaderLines& lines, const std::string& key, const PcdInput& input) {
  const Words* const line = find_line(lines, key);
  if (line == nullptr) refuse(input, "the header has no " + key + "; PCD v0.7 asks for it");
  return *line;
}

std::uint32_t number(const std::string& word, const std::string& key, const PcdInput& input) {
  std::uint32_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stopped != end) {
    refuse(input, "the header's " + key + " is '" + word + "'; expected a whole number from 0 to " +
                      std::to_string(std::numeric_limits<std::uint32_t>::max()));
  }
  return value;
}

void check_field(const PcdField& field, const PcdInput& input) {
  const bool integer = field.type == 'I' || field.type == 'U';
  const bool size_known =
      field.size == 8 || field.size == 4 || (integer && (field.size == 1 || field.size == 2));
  if ((!integer && field.type != 'F') || !size_known) {
    refuse(input, "field " + field.name + " has TYPE " + field.type + " and SIZE " +
                      std::to_string(field.size) +
                      "; known are I and U of 1, 2, 4, 8 bytes and F of 4, 8");
  }
  if (field.bytes() > largest_point_bytes) {
    refuse(input, "field " + field.name + " has COUNT " + std::to_string(field.count) +
                      "; expected at most 64 kB a point");
  }
}

char type_of(const std::string& word) {
  if (word == "i" || word == "I") return 'I';
  if (word == "u" || word == "U") return 'U';
  if (word == "f" || word == "F") return 'F';
  return word.size() == 1 ? word.front() : '?';
}

std::vector<PcdField> fields_of(const HeaderLines& lines, const PcdInput& input) {
  const Words& names = line_of(lines, "FIELDS", input);
  const auto words_or = [&](const char* key, const char* otherwise) {
    const Words* const line = find_line(lines, key);
    return line != nullptr ? *line : Words(names.size(), otherwise);
  };
  // Before PCD 0.6, all fields were floats.
  const bool is_old = !lines.contains("SIZE") && !lines.contains("TYPE");
  const Words sizes = is_old ? words_or("SIZE", "4") : line_of(lines, "SIZE", input);
  const Words types = is_old ? words_or("TYPE", "F") : line_of(lines, "TYPE", input);
  const Words counts = words_or("COUNT", "1");
  if (sizes.size() != names.size() || types.size() != names.size() ||
      counts.size() != names.size()) {
    refuse(input, "the header's FIELDS, SIZE, TYPE and COUNT have " + std::to_string(names.size()) +
                      ", " + std::to_string(sizes.size()) + ", " + std::to_string(types.size()) +
                      " and " + std::to_string(counts.size()) +
                      " entries; they must have as many each");
  }
  std::vector<PcdField> fields;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    fields.push_back({names[i], type_of(types[i]), number(sizes[i], "SIZE", input),
                      number(counts[i], "COUNT", input)});
    check_field(fields.back(), input);
    if (!fields.back().is_padding() && !seen.insert(names[i]).second) {
      refuse(input, "the header names the field " + names[i] + " twice; rename one of them");
    }
  }
  return fields;
}

void check_coordinates(const PcdHeader& header, const PcdInput& input) {
  for (const char* const name : {"x", "y", "z"}) {
    const auto field = header.find(name);
    if (field && header.fields[*field].count == 1) continue;
    std::string names;
    for (const PcdField& other : header.fields) names += " " + other.name;
    refuse(input,
           std::string("has no field ") + name + " of one number a point; its fields are" + names);
  }
}

std::uint64_t points_of(const Words& words, const PcdInput& input) {
  std::uint64_t points = 0;
  const char* const end = words.front().data() + words.front().size();
  const auto [stopped, error] = std::from_chars(words.front().data(), end, points);
  if (error != std::errc() || stopped != end) {
    refuse(input, "the header's POINTS is '" + words.front() + "'; expected a whole number");
  }
  return points;
}

// Missing sizes are completed from the others; 0 counts as missing, as in old files.
void read_size(const HeaderLines& lines, PcdHeader& header, const PcdInput& input) {
  const Words* const width = find_line(lines, "WIDTH");
  const Words* const height = find_line(lines, "HEIGHT");
  const Words* const points_line = find_line(lines, "POINTS");
  if (width == nullptr && points_line == nullptr) {
    refuse(input, "the header has neither WIDTH nor POINTS; PCD v0.7 asks for both");
  }
  if (width != nullptr) header.width = number(width->front(), "WIDTH", input);
  header.height = height != nullptr ? number(height->front(), "HEIGHT", input) : 0;
  const bool lacks_width = header.width == 0 && (width == nullptr || header.height == 0);
  if (header.height == 0) header.height = 1;
  const std::uint64_t points =
      points_line != nullptr ? points_of(*points_line, input) : header.points();
  const std::uint64_t columns = points / header.height;
  if (lacks_width && columns <= std::numeric_limits<std::uint32_t>::max()) {
    header.width = static_cast<std::uint32_t>(columns);
  }
  if (points != header.points()) {
    refuse(input, "the header's WIDTH x HEIGHT is " + std::to_string(header.width) + " x " +
                      std::to_string(header.height) + " but its POINTS is " +
                      std::to_string(points) + "; make them agree");
  }
  if (points == 0) {
    input.refuse(PcdCause::no_points, "holds no point; there is nothing to segment");
  }
}

// Blanks keep the numbers apart, or commas or semicolons.
std::array<double, 7> viewpoint_of(const Words& words, const PcdInput& input) {
  std::string joined;
  for (const std::string& word : words) joined += word + ' ';
  std::ranges::replace_if(
      joined, [](char c) { return c == ',' || c == ';'; }, ' ');
  std::string_view rest = joined;
  std::array<double, 7> viewpoint{};
  std::size_t found = 0;
  for (std::string_view word; !(word = take_word(rest)).empty(); ++found) {
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stopped, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || stopped != end || !std::isfinite(value)) {
      refuse(input,
             "the header's VIEWPOINT has '" + std::string(word) + "'; expected a finite number");
    }
    if (found < viewpoint.size()) viewpoint[found] = value;
  }
  if (found != viewpoint.size()) {
    refuse(input, "the header's VIEWPOINT has " + std::to_string(found) +
                      " numbers; expected 7: tx ty tz qw qx qy qz");
  }
  return viewpoint;
}

PcdEncoding encoding_of(const std::string& word, const PcdInput& input) {
  if (word == "ascii") return PcdEncoding::ascii;
  if (word == "binary") return PcdEncoding::binary;
  if (word == "binary_compressed") return PcdEncoding::binary_compressed;
  refuse(input,
         "the header's DATA is '" + word + "'; known are ascii, binary and binary_compressed");
}

}  // namespace

std::size_t PcdHeader::point_bytes() const {
  return offset_of(fields.size());
}

std::size_t PcdHeader::offset_of(std::size_t field) const {
  return std::accumulate(
      fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(field), std::size_t{0},
      [](std::size_t sum, const PcdField& before) { return sum + before.bytes(); });
}

std::optional<std::size_t> PcdHeader::find(std::string_view name) const {
  const auto found = std::ranges::find(fields, name, &PcdField::name);
  if (found == fields.end()) return std::nullopt;
  return static_cast<std::size_t>(found - fields.begin());
}

PcdHeader read_pcd_header(PcdInput& input) {
  const HeaderLines lines = read_header_lines(input);
  PcdHeader header;
  header.fields = fields_of(lines, input);
  if (header.point_bytes() > largest_point_bytes) refuse(input, "has more than 64 kB a point");
  check_coordinates(header, input);
  read_size(lines, header, input);
  if (const Words* const viewpoint = find_line(lines, "VIEWPOINT")) {
    header.viewpoint = viewpoint_of(*viewpoint, input);
  }
  header.encoding = encoding_of(line_of(lines, "DATA", input).front(), input);
  return header;
}

}  // namespace cleave::recording
