#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "cleave/cloud/pcd_header.hpp"

namespace cleave::client {
namespace {

// LZF's densest code: 3 bytes that stand for 264.
constexpr std::size_t lzf_largest_ratio = 88;

[[noreturn]] void refuse_truncated(const std::filesystem::path& file, const PcdHeader& header,
                                   const std::string& found) {
  throw PcdError(file.string() + ": the header promises " + std::to_string(header.points()) +
                 " points of " + std::to_string(header.point_bytes()) + " bytes, but " + found +
                 "; the file is cut off or its header is wrong: copy or record it again");
}

void check_binary(const std::filesystem::path& file, const PcdHeader& header,
                  std::size_t available) {
  if (header.points() > available / header.point_bytes()) {
    refuse_truncated(file, header, std::to_string(available) + " bytes follow");
  }
}

// The points as one LZF block behind its two sizes; padding is not stored.
void check_compressed(const std::filesystem::path& file, const PcdHeader& header,
                      std::istream& stream, std::size_t available) {
  std::array<std::uint32_t, 2> sizes{};
  if (!stream.read(reinterpret_cast<char*>(sizes.data()), sizeof(sizes))) {
    refuse_truncated(file, header, "no compressed block follows");
  }
  const auto [compressed, uncompressed] = sizes;
  std::size_t stored_point_bytes = 0;
  for (const PcdField& field : header.fields) {
    if (field.name != "_") stored_point_bytes += field.bytes();
  }
  if (compressed > available - sizeof(sizes)) {
    refuse_truncated(file, header,
                     "its compressed block of " + std::to_string(compressed) +
                         " bytes ends after " + std::to_string(available - sizeof(sizes)));
  }
  if (stored_point_bytes == 0 || uncompressed % stored_point_bytes != 0 ||
      uncompressed / stored_point_bytes != header.points()) {
    refuse_truncated(file, header,
                     "its compressed block unpacks to " + std::to_string(uncompressed) + " bytes");
  }
  if (uncompressed / lzf_largest_ratio > compressed) {
    refuse_truncated(file, header,
                     "its compressed block of " + std::to_string(compressed) +
                         " bytes cannot unpack to " + std::to_string(uncompressed));
  }
}

bool is_number(const std::string& word) {
  char* stopped = nullptr;
  std::strtod(word.c_str(), &stopped);
  return stopped == word.c_str() + word.size();
}

// One point a line, one word an element.
void check_ascii(const std::filesystem::path& file, const PcdHeader& header, std::istream& stream) {
  std::size_t elements = 0;
  for (const PcdField& field : header.fields) elements += field.count;
  std::size_t points = 0;
  std::string line;
  while (points < header.points() && std::getline(stream, line)) {
    std::istringstream words(line);
    std::size_t found = 0;
    for (std::string word; words >> word; ++found) {
      if (!is_number(word)) {
        throw PcdError(file.string() + ": point " + std::to_string(points) + " has '" + word +
                       "' where a number is expected; correct it");
      }
    }
    if (found == 0) continue;
    if (found != elements) {
      throw PcdError(file.string() + ": point " + std::to_string(points) + " has " +
                     std::to_string(found) + " numbers, its fields ask for " +
                     std::to_string(elements) + "; correct the line or the header");
    }
    ++points;
  }
  if (points < header.points()) {
    refuse_truncated(file, header, std::to_string(points) + " lines of points follow");
  }
}

}  // namespace

void check_pcd_data(const std::filesystem::path& file, const PcdHeader& header) {
  const std::size_t size = std::filesystem::file_size(file);
  const std::size_t available = size > header.data_offset ? size - header.data_offset : 0;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(header.data_offset));
  switch (header.encoding) {
    case PcdEncoding::ascii:
      return check_ascii(file, header, stream);
    case PcdEncoding::binary:
      return check_binary(file, header, available);
    case PcdEncoding::binary_compressed:
      return check_compressed(file, header, stream, available);
  }
}

}  // namespace cleave::client
