// SPDX-License-Identifier: BSD-3-Clause
// PCD files for tests, written by hand so that they may be as wrong as a test needs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::recording {

// Removed at the end of the test with all that is in it.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Writes a file into it.
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

struct PcdText {
  std::string fields = "x y z";
  std::string size = "4 4 4";
  std::string type = "F F F";
  std::string count = "1 1 1";
  std::string width = "2";
  std::string height = "1";
  std::string viewpoint = "0 0 0 1 0 0 0";
  std::string points = "2";
  std::string encoding = "ascii";
  std::string data = "1 2 3\n4 5 6\n";
};
[[nodiscard]] std::string to_file(const PcdText& pcd);
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// How a file with this content is taken: "" or "bad header: FILE: the header ...".
[[nodiscard]] std::string refusal_of(const std::string& content);
// Fails unless the refusal has the cause and says `why`.
void expect_refused(const std::string& content, const std::string& cause, const std::string& why);

// Bytes of the values, one after the other.
template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// A binary file of these x, y, z.
[[nodiscard]] std::string binary_file(const std::vector<float>& xyz, std::uint32_t width,
                                      std::uint32_t height);

// The body of a binary_compressed file: the two sizes, and LZF that consists of literals only.
[[nodiscard]] std::string compressed_body(const std::string& bytes);

}  // namespace cleave::recording
