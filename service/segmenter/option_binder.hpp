// SPDX-License-Identifier: BSD-3-Clause
// Binds the options of the segmentation to the YAML section of the same name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/section.hpp"

namespace cleave::service {

// A visitor for segmentation::visit_options: the option "voxel.size_m" is the key `size_m` of the
// section `voxel`; one without a dot is a key of the section itself. Options that the file does not
// name keep their values; wrong ones throw config::ConfigurationError.
class OptionBinder {
 public:
  explicit OptionBinder(config::Section& section) : root_(section) {}

  void number(std::string_view name, float& value, double min, double max, std::string_view) {
    const auto [section, key] = find(name);
    section->number(key, value, min, max);
  }
  void integer(std::string_view name, std::uint32_t& value, std::uint32_t min, std::uint32_t max,
               std::string_view) {
    const auto [section, key] = find(name);
    section->integer(key, value, min, max);
  }
  void boolean(std::string_view name, bool& value, std::string_view) {
    const auto [section, key] = find(name);
    section->boolean(key, value);
  }
  template <class Names>
  void choice(std::string_view name, std::size_t& index, const Names& names, std::string_view) {
    const auto [section, key] = find(name);
    section->choice(key, index, std::vector<std::string>(names.begin(), names.end()));
  }

  // Refuses an option that the file names, with its line: see config::Section::refuse.
  [[noreturn]] void refuse(std::string_view name, const std::string& expected) {
    const auto [section, key] = find(name);
    section->refuse(key, expected);
  }

 private:
  std::pair<config::Section*, std::string_view> find(std::string_view name) {
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos) return {&root_, name};
    const std::string step(name.substr(0, dot));
    auto found = steps_.find(step);
    if (found == steps_.end()) found = steps_.emplace(step, root_.section(step)).first;
    return {&found->second, name.substr(dot + 1)};
  }

  config::Section& root_;
  std::map<std::string, config::Section> steps_;
};

}  // namespace cleave::service
