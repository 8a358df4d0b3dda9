// SPDX-License-Identifier: BSD-3-Clause
// Writes small .oni files, record by record, as OpenNI's recorder does.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cleave::oni::test {

using Image = std::vector<std::uint16_t>;

// OpenNI2's encoders (XnStreamCompression.cpp), order of the last bytes included.
std::string encode_differences(const Image& values);  // "16zP"
std::string encode_with_table(const Image& pixels);   // "16zT"
std::string encode_raw(const Image& pixels);          // "NONE"

struct OniFile {
  std::uint32_t width = 16;
  std::uint32_t height = 12;
  std::string codec = "16zT";
  bool wide = true;  // false: version 1.0.0.6, with positions of 4 bytes
  std::uint64_t pixel_format = 100;
  bool mirrored = false;
  std::vector<std::uint16_t> cropping;  // x, y, width, height
  bool with_fov = true;
  std::uint64_t first_timestamp_us = 0;
  std::vector<Image> frames;
  bool with_end = true;
  std::uint32_t depth_node_type = 2;

  // The file, and where each frame's record begins.
  [[nodiscard]] std::string bytes(std::vector<std::size_t>* positions = nullptr) const;
};

// Images of planes with steps, noise and holes. Deterministic.
Image example_image(std::uint32_t width, std::uint32_t height, std::uint32_t seed);

// A file of its own for a test, removed with the object.
class TestFile {
 public:
  explicit TestFile(const std::string& content);
  ~TestFile();
  TestFile(const TestFile&) = delete;
  TestFile& operator=(const TestFile&) = delete;
  void write(const std::string& content) const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cleave::oni::test
