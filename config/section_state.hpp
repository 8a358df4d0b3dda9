// SPDX-License-Identifier: BSD-3-Clause
// What a Section is behind its header: a YAML mapping and what has been asked of it.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/section.hpp"

namespace cleave::config {

struct Section::State {
  std::string file;
  std::string path;    // "video." for the keys of the mapping `video`; empty at the top
  YAML::Node mapping;  // null where the section is absent
  int line = 1;
  std::vector<std::string> known = {};
  // Sections below, kept so that finish() sees them.
  std::vector<std::pair<std::string, std::shared_ptr<State>>> children = {};

  [[nodiscard]] static std::shared_ptr<State> load(const std::filesystem::path& file);
  // The value of `key`, which is known from now on; undefined where it is absent.
  [[nodiscard]] YAML::Node find(std::string_view key);
  // The value of `key`; undefined where it is absent.
  [[nodiscard]] YAML::Node value_of(std::string_view key) const;
  // The mapping at `key`, as State::find does.
  [[nodiscard]] std::shared_ptr<State> child(std::string_view key);
  // Throws for a key that is no text or stands there twice: one of the two would silently win.
  void check_mapping() const;
  // Throws for the first unknown key, here or below.
  void finish() const;
  // Throws "expected ..., found ..." for the value of `key`.
  [[noreturn]] void refuse(std::string_view key, const YAML::Node& found,
                           const std::string& expected) const;
  [[noreturn]] void fail(const YAML::Node& where, std::string_view key,
                         const std::string& problem) const;
  [[nodiscard]] int line_of(const YAML::Node& value, std::string_view key) const;
};

[[nodiscard]] std::string joined(const std::vector<std::string>& words);

}  // namespace cleave::config
