// SPDX-License-Identifier: BSD-3-Clause
// A folder of its own for each test, gone when the test ends.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cleave::tests {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Writes a file into the folder.
  [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view content) const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_file(const std::filesystem::path& file);

}  // namespace cleave::tests
