#include "sensor/pcd_header.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

#include "sensor/source.hpp"

namespace cleave::sensor {
namespace {

constexpr std::size_t max_header_bytes = 65536;
constexpr std::uint64_t max_decoded_bytes = std::uint64_t{512} << 20U;

using Words = std::vector<std::string>;
using Entries = std::map<std::string, Words>;  // keyword to the words behind it
using Problem = std::optional<PcdProblem>;

constexpr std::array<std::string_view, 10> keywords = {
    "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

PcdProblem bad_header(const std::string& detail) {
  return {"bad header", detail};
}

// The lines up to DATA, and where the data begins. A second line of a kind is refused: PCL might
// believe the other one.
Problem read_entries(std::istream& stream, Entries& entries, std::uint64_t& data_begin) {
  std::string head(max_header_bytes, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  stream.clear();  // a short file was read to its end
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = head.find('\n', begin)) != std::string::npos; begin = end + 1) {
    std::istringstream line(head.substr(begin, end - begin));
    std::string keyword;
    line >> keyword;
    if (keyword.empty() || keyword.front() == '#') continue;
    if (std::find(keywords.begin(), keywords.end(), keyword) == keywords.end()) {
      return PcdProblem{"not PCD", "a header line is none of PCD's"};
    }
    const auto [entry, is_new] = entries.try_emplace(keyword);
    if (!is_new) return bad_header(keyword + " stands there twice");
    for (std::string word; line >> word;) entry->second.push_back(word);
    if (keyword == "DATA") {
      data_begin = end + 1;
      return std::nullopt;
    }
  }
  if (entries.empty()) return PcdProblem{"not PCD", "there is no header"};
  return PcdProblem{"truncated", "the header ends before its DATA line"};
}

bool parse(const Words& words, std::size_t i, std::uint64_t& number) {
  if (i >= words.size()) return false;
  const char* const end = words[i].data() + words[i].size();
  const auto [last, error] = std::from_chars(words[i].data(), end, number);
  return error == std::errc{} && last == end;
}

Problem read_fields(Entries& entries, std::vector<PcdField>& fields) {
  const Words& names = entries["FIELDS"];
  const Words& types = entries["TYPE"];
  const bool has_counts = entries.count("COUNT") > 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    PcdField field{names[i], i < types.size() ? types[i].front() : '?', 0, 1};
    const bool sized = parse(entries["SIZE"], i, field.size) &&
                       (field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8);
    const bool counted = !has_counts || (parse(entries["COUNT"], i, field.count) &&
                                         field.count >= 1 && field.count <= max_decoded_bytes);
    const bool typed = field.type == 'F' || field.type == 'I' || field.type == 'U';
    if (!sized || !counted || !typed) {
      return bad_header("SIZE, TYPE or COUNT of field '" + names[i] + "' is missing or impossible");
    }
    fields.push_back(field);
  }
  return std::nullopt;
}

Problem check_coordinates(const std::vector<PcdField>& fields) {
  for (const char* const name : {"x", "y", "z"}) {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const PcdField& f) { return f.name == name; });
    if (field == fields.end()) return bad_header(std::string("there is no field ") + name);
    if (field->type != 'F' || field->size < 4 || field->count != 1) {
      return bad_header(std::string("field ") + name + " is not a float or double");
    }
  }
  return std::nullopt;
}

Problem read_size(Entries& entries, PcdHeader& header) {
  if (!parse(entries["WIDTH"], 0, header.width) || !parse(entries["HEIGHT"], 0, header.height) ||
      !parse(entries["POINTS"], 0, header.points)) {
    return bad_header("WIDTH, HEIGHT or POINTS is missing or not a number");
  }
  const std::string size = std::to_string(header.width) + " x " + std::to_string(header.height);
  const std::string points = std::to_string(header.points) + " points";
  if (header.points == 0) return PcdProblem{"no points", size + ", " + points};
  if (header.points > capacity_points) {
    return PcdProblem{"too many points", points + "; at most 307200 (640 x 480) fit a cloud"};
  }
  // Divided, not multiplied: the product could overflow.
  if (header.width == 0 || header.points % header.width != 0 ||
      header.points / header.width != header.height) {
    return bad_header("WIDTH x HEIGHT is " + size + ", but POINTS is " +
                      std::to_string(header.points));
  }
  return std::nullopt;
}

Problem read_encoding(const Words& words, PcdEncoding& encoding) {
  const std::array<std::string_view, 3> names = {"ascii", "binary", "binary_compressed"};
  const auto* const name =
      words.empty() ? names.end() : std::find(names.begin(), names.end(), words.front());
  if (name == names.end()) return bad_header("DATA is none of ascii, binary, binary_compressed");
  encoding = static_cast<PcdEncoding>(name - names.begin());
  return std::nullopt;
}

// A compressed body begins with its size and the size that it decodes to.
Problem check_compressed(std::istream& stream, std::uint64_t data_bytes, std::uint64_t decoded) {
  std::array<std::uint32_t, 2> sizes{};
  if (!stream.read(reinterpret_cast<char*>(sizes.data()), sizeof sizes) ||
      sizes[0] > data_bytes - sizeof sizes) {
    return PcdProblem{"truncated", "the compressed data ends early"};
  }
  if (sizes[1] != decoded) {
    return PcdProblem{"damaged data", "the compressed data decodes to " + std::to_string(sizes[1]) +
                                          " bytes, the header needs " + std::to_string(decoded)};
  }
  return std::nullopt;
}

Problem check_data(std::istream& stream, const PcdHeader& header, std::uint64_t data_bytes) {
  std::uint64_t values = 0, step = 0;
  for (const PcdField& field : header.fields) {
    values += field.count;
    step += field.count * field.size;
    if (step > max_decoded_bytes / header.points) return bad_header("more than 512 MiB of data");
  }
  if (header.encoding == PcdEncoding::binary_compressed) {
    return check_compressed(stream, data_bytes, step * header.points);
  }
  // In ascii a value takes a digit and a separator at least; the last one needs no separator.
  const std::uint64_t needed = header.encoding == PcdEncoding::binary
                                   ? step * header.points
                                   : 2 * values * header.points - 1;
  if (data_bytes >= needed) return std::nullopt;
  return PcdProblem{"truncated", std::to_string(data_bytes) + " bytes of data, at least " +
                                     std::to_string(needed) + " needed"};
}

}  // namespace

std::variant<PcdHeader, PcdProblem> read_pcd_header(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    return PcdProblem{"unreadable", error ? error.message() : "not a regular file"};
  }
  const std::uint64_t file_bytes = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream) return PcdProblem{"unreadable", std::strerror(errno)};

  Entries entries;
  std::uint64_t data_begin = 0;
  PcdHeader header;
  Problem problem = read_entries(stream, entries, data_begin);
  if (!problem) problem = read_fields(entries, header.fields);
  if (!problem) problem = check_coordinates(header.fields);
  if (!problem) problem = read_size(entries, header);
  if (!problem) problem = read_encoding(entries["DATA"], header.encoding);
  stream.seekg(static_cast<std::streamoff>(data_begin));
  if (!problem) problem = check_data(stream, header, file_bytes - data_begin);
  if (problem) return *problem;
  return header;
}

}  // namespace cleave::sensor
