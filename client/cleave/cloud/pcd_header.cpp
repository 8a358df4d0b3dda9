#include "cleave/cloud/pcd_header.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

namespace cleave::client {
namespace {

constexpr std::size_t longest_header_bytes = std::size_t{64} * 1024;
constexpr std::size_t largest_point_bytes = std::size_t{64} * 1024;

constexpr std::array<std::string_view, 10> keywords = {
    "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

using Words = std::vector<std::string>;

// The lines of the header by their first word.
struct HeaderLines {
  std::map<std::string, Words> values;
  std::size_t data_offset = 0;
};

// Refuses one file, for different reasons.
class Refusal {
 public:
  explicit Refusal(const std::filesystem::path& file) : file_(file) {}
  [[noreturn]] void operator()(const std::string& why) const {
    throw PcdError(file_.string() + ": " + why);
  }

 private:
  const std::filesystem::path& file_;
};

HeaderLines split_header(std::istream& stream, const Refusal& refuse) {
  HeaderLines lines;
  std::string line;
  while (std::getline(stream, line)) {
    lines.data_offset += line.size() + 1;
    if (lines.data_offset > longest_header_bytes) break;
    std::istringstream words(line);
    std::string key;
    if (!(words >> key) || key.front() == '#') continue;
    // PCL stops at a line that it does not know, and then reads points from anywhere.
    if (std::find(keywords.begin(), keywords.end(), key) == keywords.end()) {
      refuse("is no PCD file, or is damaged: a header line begins with none of PCD's words");
    }
    Words& values = lines.values[key];
    if (!values.empty()) refuse("the header has two lines " + key + "; write the file anew");
    for (std::string word; words >> word;) values.push_back(word);
    if (key == "DATA") return lines;
  }
  refuse("is no PCD file, or is cut off in its header: there is no line DATA in its first 64 kB");
}

const Words& line_of(const HeaderLines& lines, const std::string& key, const Refusal& refuse) {
  const auto found = lines.values.find(key);
  if (found == lines.values.end() || found->second.empty()) {
    refuse("the header has no " + key + "; PCD v0.7 asks for it");
  }
  return found->second;
}

template <class Number>
Number number(const std::string& word, const std::string& key, const Refusal& refuse) {
  Number value{};
  const char* end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stopped != end) {
    refuse("the header's " + key + " is '" + word + "'; expected a number from 0 to " +
           std::to_string(std::numeric_limits<Number>::max()));
  }
  return value;
}

void check_field(const PcdField& field, const Refusal& refuse) {
  const bool integer = field.type == 'I' || field.type == 'U';
  const bool size_known =
      field.size == 8 || field.size == 4 || (integer && (field.size == 1 || field.size == 2));
  if ((!integer && field.type != 'F') || !size_known) {
    refuse("field " + field.name + " has TYPE " + field.type + " and SIZE " +
           std::to_string(field.size) + "; known are I and U of 1, 2, 4, 8 bytes and F of 4, 8");
  }
  if (field.count == 0 || field.bytes() > largest_point_bytes) {
    refuse("field " + field.name + " has COUNT " + std::to_string(field.count) +
           "; expected 1 or more, and at most 64 kB a point");
  }
}

std::vector<PcdField> fields_of(const HeaderLines& lines, const Refusal& refuse) {
  const Words& names = line_of(lines, "FIELDS", refuse);
  const Words& sizes = line_of(lines, "SIZE", refuse);
  const Words& types = line_of(lines, "TYPE", refuse);
  const Words counts =
      lines.values.contains("COUNT") ? lines.values.at("COUNT") : Words(names.size(), "1");
  if (sizes.size() != names.size() || types.size() != names.size() ||
      counts.size() != names.size()) {
    refuse("the header's FIELDS, SIZE, TYPE and COUNT have " + std::to_string(names.size()) + ", " +
           std::to_string(sizes.size()) + ", " + std::to_string(types.size()) + " and " +
           std::to_string(counts.size()) + " entries; they must have as many each");
  }
  std::vector<PcdField> fields;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char type = types[i].size() == 1 ? types[i].front() : '?';
    fields.push_back({names[i], type, number<std::uint32_t>(sizes[i], "SIZE", refuse),
                      number<std::uint32_t>(counts[i], "COUNT", refuse)});
    check_field(fields.back(), refuse);
    if (names[i] != "_" && !seen.insert(names[i]).second) {
      refuse("the header names the field " + names[i] + " twice; rename one of them");
    }
  }
  return fields;
}

void read_size(const HeaderLines& lines, PcdHeader& header, const Refusal& refuse) {
  header.width = number<std::uint32_t>(line_of(lines, "WIDTH", refuse).front(), "WIDTH", refuse);
  header.height = number<std::uint32_t>(line_of(lines, "HEIGHT", refuse).front(), "HEIGHT", refuse);
  const auto points =
      number<std::uint64_t>(line_of(lines, "POINTS", refuse).front(), "POINTS", refuse);
  if (points != header.points()) {
    refuse("the header's WIDTH x HEIGHT is " + std::to_string(header.width) + " x " +
           std::to_string(header.height) + " but its POINTS is " + std::to_string(points) +
           "; make them agree");
  }
  if (points == 0) refuse("holds no point; there is nothing to segment");
}

std::string viewpoint_of(const Words& words, const Refusal& refuse) {
  std::string text;
  for (const std::string& word : words) {
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stopped != end || !std::isfinite(value)) {
      refuse("the header's VIEWPOINT has '" + word + "'; expected a finite number");
    }
    text += (text.empty() ? "" : " ") + word;
  }
  if (words.size() != 7) {
    refuse("the header's VIEWPOINT has " + std::to_string(words.size()) +
           " numbers; expected 7: tx ty tz qw qx qy qz");
  }
  return text;
}

PcdEncoding encoding_of(const std::string& word, const Refusal& refuse) {
  if (word == "ascii") return PcdEncoding::ascii;
  if (word == "binary") return PcdEncoding::binary;
  if (word == "binary_compressed") return PcdEncoding::binary_compressed;
  refuse("the header's DATA is '" + word + "'; known are ascii, binary and binary_compressed");
}

}  // namespace

std::size_t PcdHeader::point_bytes() const {
  return std::accumulate(
      fields.begin(), fields.end(), std::size_t{0},
      [](std::size_t sum, const PcdField& field) { return sum + field.bytes(); });
}

std::optional<std::size_t> PcdHeader::find(std::string_view name) const {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const PcdField& field) { return field.name == name; });
  if (found == fields.end()) return std::nullopt;
  return static_cast<std::size_t>(found - fields.begin());
}

PcdHeader read_pcd_header(const std::filesystem::path& file) {
  const Refusal refuse(file);
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file)) {
    refuse("is no regular file; name a PCD file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(std::string("cannot be read: ") + std::strerror(errno));

  const HeaderLines lines = split_header(stream, refuse);
  PcdHeader header;
  header.fields = fields_of(lines, refuse);
  if (header.point_bytes() > largest_point_bytes) refuse("has more than 64 kB a point");
  read_size(lines, header, refuse);
  if (lines.values.contains("VIEWPOINT")) {
    header.viewpoint = viewpoint_of(lines.values.at("VIEWPOINT"), refuse);
  }
  header.encoding = encoding_of(line_of(lines, "DATA", refuse).front(), refuse);
  header.data_offset = lines.data_offset;
  return header;
}

}  // namespace cleave::client
