// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/recording/oni/oni_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <set>
#include <stdexcept>

namespace cleave::oni::test {
namespace {

template <class T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put_text(std::string& out, const std::string& text) {
  put(out, static_cast<std::uint32_t>(text.size() + 1));
  out += text + '\0';
}

std::string record(bool wide, std::uint32_t type, std::uint32_t node, const std::string& fields,
                   const std::string& payload = "") {
  const std::size_t header = wide ? 28 : 24;
  std::string out("NIR\0", 4);
  put(out, type);
  put(out, node);
  put(out, static_cast<std::uint32_t>(header + fields.size()));
  put(out, static_cast<std::uint32_t>(payload.size()));
  out.resize(header);  // no record is undone
  return out + fields + payload;
}

std::string property(const std::string& name, const std::string& value) {
  std::string fields;
  put_text(fields, name);
  put(fields, static_cast<std::uint32_t>(value.size()));
  return fields + value;
}

template <class... T>
std::string values(T... value) {
  std::string out;
  (put(out, value), ...);
  return out;
}

std::string encode(const std::string& codec, const Image& image) {
  if (codec == "16zT") return encode_with_table(image);
  return codec == "16zP" ? encode_differences(image) : encode_raw(image);
}

}  // namespace

std::string encode_differences(const Image& image) {
  std::string out;
  put(out, image.at(0));
  unsigned pending = 0, pairs = 0;
  bool has_pending = false;
  const auto byte = [&](unsigned value) { out += static_cast<char>(value); };
  const auto end_run = [&] {
    if (pairs > 0) byte(0xE0 + pairs);
    pairs = 0;
  };
  for (std::size_t i = 1; i < image.size(); ++i) {
    const int difference = image[i - 1] - image[i];
    if (std::abs(difference) <= 6) {
      const auto coded = static_cast<unsigned>(difference + 6);
      if (!has_pending) {
        pending = coded << 4U;
      } else if ((pending | coded) == 0x66) {
        if (++pairs == 15) end_run();
      } else {
        end_run();
        byte(pending | coded);
      }
      has_pending = !has_pending;
      continue;
    }
    end_run();
    byte(has_pending ? pending | 0xFU : 0xFFU);
    has_pending = false;
    if (std::abs(difference) <= 63) {
      byte(static_cast<unsigned>(difference + 192));
    } else {
      byte(image[i] >> 8U);
      byte(image[i] & 0xFFU);
    }
  }
  if (has_pending) byte(pending | 0xDU);
  end_run();
  return out;
}

std::string encode_with_table(const Image& pixels) {
  const std::set<std::uint16_t> sorted(pixels.begin(), pixels.end());
  const std::vector<std::uint16_t> table(sorted.begin(), sorted.end());
  std::string out;
  put(out, static_cast<std::uint16_t>(table.size()));
  for (const std::uint16_t value : table) put(out, value);
  Image indices;
  for (const std::uint16_t pixel : pixels) {
    const auto place = std::ranges::lower_bound(table, pixel) - table.begin();
    indices.push_back(static_cast<std::uint16_t>(place));
  }
  return out + encode_differences(indices);
}

std::string encode_raw(const Image& pixels) {
  return {reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(std::uint16_t)};
}

std::string OniFile::bytes(std::vector<std::size_t>* positions) const {
  constexpr std::uint32_t node = 1;
  std::string out =
      "NI10" + values(std::uint8_t{1}, std::uint8_t{0}, static_cast<std::uint16_t>(wide ? 1 : 0),
                      std::uint32_t{wide ? 0U : 6U}, ~std::uint64_t{0}, node);
  const auto add = [&](std::uint32_t type, const std::string& fields,
                       const std::string& payload = "") {
    out += record(wide, type, node, fields, payload);
  };
  const auto integer = [&](const std::string& name, std::uint64_t value) {
    add(0x03, property(name, values(value)));
  };
  std::string added;
  put_text(added, "Depth");
  put(added, depth_node_type);
  added += codec + values(static_cast<std::uint32_t>(frames.size()), std::uint64_t{0},
                          ~std::uint64_t{0}, std::uint64_t{0});
  add(0x0D, added);
  integer("oniPixelFormat", pixel_format);
  integer("xnMirror", mirrored ? 1 : 0);
  add(0x06, property("xnMapOutputMode", values(width, height, std::uint32_t{30})));
  if (with_fov) add(0x06, property("xnFOV", values(1.0226, 0.7966)));
  if (!cropping.empty()) {
    add(0x06, property("xnCropping", values(std::uint32_t{1}, cropping.at(0), cropping.at(1),
                                            cropping.at(2), cropping.at(3))));
  }
  add(0x09, "");
  add(0x08, values(~std::uint32_t{0}, ~std::uint64_t{0}));
  for (std::uint32_t i = 0; i < frames.size(); ++i) {
    if (positions != nullptr) positions->push_back(out.size());
    add(0x0A, values(first_timestamp_us + std::uint64_t{33333} * i, i + 1),
        encode(codec, frames[i]));
  }
  add(0x07, "");
  if (with_end) add(0x0B, "");
  return out;
}

Image example_image(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
  std::mt19937 random(seed);
  Image image;
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const std::uint32_t column = i % width;
    const std::uint32_t plane = 800 + 3 * column + (column > width / 2 ? 400 : 0);
    const bool hole = random() % 8 == 0;
    image.push_back(static_cast<std::uint16_t>(hole ? 0 : plane + random() % 3));
  }
  return image;
}

TestFile::TestFile(const std::string& content) {
  std::string name = (std::filesystem::temp_directory_path() / "cleave-oni-XXXXXX").string();
  const int file = ::mkstemp(name.data());
  if (file < 0) throw std::runtime_error("cannot create " + name);
  ::close(file);
  path_ = name;
  write(content);
}

TestFile::~TestFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void TestFile::write(const std::string& content) const {
  std::ofstream file(path_, std::ios::binary | std::ios::trunc);
  file << content;
  if (!file.flush()) throw std::runtime_error("cannot write " + path_.string());
}

}  // namespace cleave::oni::test
