// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <sstream>

#include "recording/pcd/encoding/lzf.hpp"
#include "recording/replace_file.hpp"

namespace cleave::recording {
namespace {

// In as few digits as give the same number back.
std::string viewpoint_text(const PcdHeader& header) {
  std::string text;
  for (const double value : header.viewpoint.value_or(std::array<double, 7>{0, 0, 0, 1, 0, 0, 0})) {
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.begin(), digits.end(), value);
    text.append(" ").append(digits.begin(), end);
  }
  return text;
}

std::string header_text(const PcdHeader& header, const char* encoding) {
  std::ostringstream names;
  std::ostringstream sizes;
  std::ostringstream types;
  std::ostringstream counts;
  for (const PcdField& field : header.fields) {
    names << ' ' << field.name;
    sizes << ' ' << field.size;
    types << ' ' << field.type;
    counts << ' ' << field.count;
  }
  std::ostringstream text;
  text << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" << names.str()
       << "\nSIZE" << sizes.str() << "\nTYPE" << types.str() << "\nCOUNT" << counts.str()
       << "\nWIDTH " << header.width << "\nHEIGHT " << header.height << "\nVIEWPOINT"
       << viewpoint_text(header) << "\nPOINTS " << header.points() << "\nDATA " << encoding << '\n';
  return text.str();
}

// All values of the first field, then all of the second, ...: what binary_compressed stores.
std::vector<std::uint8_t> by_field(const PcdCloud& cloud) {
  const std::size_t step = cloud.header().point_bytes();
  std::vector<std::uint8_t> result;
  result.reserve(cloud.data().size());
  std::size_t offset = 0;
  for (const PcdField& field : cloud.header().fields) {
    for (std::size_t at = offset; at < cloud.data().size(); at += step) {
      const auto value = cloud.data().subspan(at, field.bytes());
      result.insert(result.end(), value.begin(), value.end());
    }
    offset += field.bytes();
  }
  return result;
}

// The two sizes and the LZF block; empty if LZF cannot make the points smaller or count their
// bytes.
std::vector<std::uint8_t> compressed(const PcdCloud& cloud) {
  const std::size_t size = cloud.data().size();
  if (size > std::numeric_limits<std::uint32_t>::max()) return {};
  std::vector<std::uint8_t> block = lzf_compressed(by_field(cloud));
  if (block.empty()) return {};
  const std::array sizes = {static_cast<std::uint32_t>(block.size()),
                            static_cast<std::uint32_t>(size)};
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(sizes.data());
  block.insert(block.begin(), bytes, bytes + sizeof sizes);
  return block;
}

}  // namespace

void write_pcd(const std::filesystem::path& file, const PcdCloud& cloud) {
  if (cloud.header().encoding != PcdEncoding::binary) {
    const std::vector<std::uint8_t> block = compressed(cloud);
    if (!block.empty()) {
      const std::string header = header_text(cloud.header(), "binary_compressed");
      replace_file(file, {std::as_bytes(std::span(header)), std::as_bytes(std::span(block))});
      return;
    }
  }
  const std::string header = header_text(cloud.header(), "binary");
  replace_file(file, {std::as_bytes(std::span(header)), std::as_bytes(cloud.data())});
}

}  // namespace cleave::recording
