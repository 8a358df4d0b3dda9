// SPDX-License-Identifier: BSD-3-Clause
// A configuration file for one test, and the message that it is refused with.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "config/section.hpp"

namespace cleave::config {

class YamlFile {
 public:
  explicit YamlFile(const std::string& content) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~YamlFile() { std::filesystem::remove(path_); }
  YamlFile(const YamlFile&) = delete;
  YamlFile& operator=(const YamlFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("cleave_test_" + std::to_string(getpid()) + ".yaml");
};

// What `load` says about a file of this content, without the folder; empty if it takes it.
template <class Load>
std::string message_for(const std::string& content, Load load) {
  const YamlFile file(content);
  try {
    load(file.path());
  } catch (const ConfigurationError& error) {
    const std::string message = error.what();
    const std::string path = file.path().string();
    return message.rfind(path, 0) == 0 ? "file" + message.substr(path.size()) : message;
  }
  return "";
}

}  // namespace cleave::config
