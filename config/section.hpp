// SPDX-License-Identifier: BSD-3-Clause
// Strict YAML: every key is asked for once, with its range; what nobody asked for is an error.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cleave::config {

// "grabber.yaml:7: source.fps: expected a number from 1 to 1000, found 'fast'"
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// One mapping of a YAML file. The getters leave `value` as it is (the default) where the key is
// absent, and throw ConfigurationError with file, line, key and what was expected where it is
// wrong.
class Section {
 public:
  // Throws ConfigurationError when the file cannot be read, is not YAML or not a mapping.
  [[nodiscard]] static Section load(const std::filesystem::path& file);
  ~Section();
  Section(Section&&) noexcept;

  void number(std::string_view key, float& value, double min, double max);
  void number(std::string_view key, double& value, double min, double max);
  void integer(std::string_view key, std::uint32_t& value, std::uint32_t min, std::uint32_t max);
  void boolean(std::string_view key, bool& value);
  void text(std::string_view key, std::string& value);
  // One of `choices`; stores its index.
  void choice(std::string_view key, std::size_t& index, const std::vector<std::string>& choices);
  void list(std::string_view key, std::vector<std::string>& value);
  // A mapping below this one; an empty section if absent.
  [[nodiscard]] Section section(std::string_view key);
  // Refuses `key`, as found, for a reason of the caller's, e.g. a sensor name that is not allowed.
  [[noreturn]] void refuse(std::string_view key, const std::string& expected) const;
  // Throws for the first key that no getter asked for, here or in a section below, and names the
  // keys that are known. Call last.
  void finish() const;

 private:
  struct State;
  explicit Section(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

}  // namespace cleave::config
